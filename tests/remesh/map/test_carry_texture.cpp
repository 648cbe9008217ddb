// Texture coordinates on a remesh: of one chart for each face, stretched at seams and never across them.
#include <cmath>

#include "gvd/carry_properties.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_carry_texture {

/// A flat square of 12 x 12 units, as from a file without a defect.
CheckedMesh make_square() {
  const Mesh grid = test::make_grid(12, 12);
  PolygonSoup soup;
  soup.positions = grid.positions();
  for (std::int32_t f = 0; f < grid.face_count(); ++f) {
    for (const VertexId v : grid.vertices(FaceId(f))) soup.corners.push_back(v.value());
    soup.close_polygon();
  }
  return build_mesh(soup);
}

/// Coordinates by a function of a corner's position and of its face's centre.
template <class Function>
CornerTexture make_texture(const Mesh& mesh, Function function) {
  CornerTexture texture;
  texture.first_corner.push_back(0);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& vertices = mesh.vertices(FaceId(f));
    const Vec3 centre = (mesh.position(vertices[0]) + mesh.position(vertices[1]) + mesh.position(vertices[2])) / 3;
    for (const VertexId v : vertices) {
      texture.corners.push_back(v.value());
      texture.coordinates.push_back(function(mesh.position(v), centre));
    }
    texture.first_corner.push_back(texture.corners.size());
  }
  return texture;
}

struct Case {
  CheckedMesh input = make_square();
  RemeshResult result = remesh(input.mesh, test::random_generators(input.mesh, 40, 2));
  RemeshMap map = map_to_remesh(input.mesh, result);

  Vec3 origin(std::size_t corner) const {
    const HalfedgeId h(corner);
    return position(input.mesh, map.origins[result.mesh.from(h)]);
  }
};

using Uv = std::array<double, 2>;

TEST_CASE("carry texture: linear coordinates without a seam are those at the origins") {
  const Case square;
  const CornerTexture texture = make_texture(square.input.mesh, [](const Vec3& p, const Vec3&) {
    return Uv{p.x() / 12, p.y() / 12 + 1};
  });
  const auto carried = carry_texture(square.input, texture, square.result, square.map);
  REQUIRE(carried.size() == static_cast<std::size_t>(square.result.mesh.halfedge_count()));
  for (std::size_t i = 0; i < carried.size(); ++i) {
    CHECK(carried[i][0] == Approx(square.origin(i).x() / 12).margin(1e-12));
    CHECK(carried[i][1] == Approx(square.origin(i).y() / 12 + 1).margin(1e-12));
  }
}

TEST_CASE("carry texture: a face beside a seam has coordinates of one side only, up to the seam") {
  const Case square;
  // The right half lies elsewhere in the texture.
  const CornerTexture texture = make_texture(square.input.mesh, [](const Vec3& p, const Vec3& centre) {
    return Uv{centre.x() < 6 ? p.x() : 100 + p.x(), p.y()};
  });
  const auto carried = carry_texture(square.input, texture, square.result, square.map);
  int across = 0;
  for (std::size_t f = 0; 3 * f < carried.size(); ++f) {
    const bool right = position(square.input.mesh, square.result.face_points[f]).x() > 6;
    for (std::size_t i = 3 * f; i < 3 * f + 3; ++i) {
      const double x = square.origin(i).x();
      across += right != (x > 6);
      const double in_chart = right ? 100 + std::max(x, 6.0) : std::min(x, 6.0);
      CHECK(carried[i][0] == Approx(in_chart).margin(1e-9));
      CHECK(carried[i][1] == Approx(square.origin(i).y()).margin(1e-9));
    }
  }
  CHECK(across > 0);
}

TEST_CASE("carry texture: where the input has none, the remesh has none") {
  const Case square;
  const CornerTexture texture = make_texture(square.input.mesh, [](const Vec3& p, const Vec3& centre) {
    return centre.x() < 6 ? Uv{p.x(), p.y()} : Uv{std::nan(""), std::nan("")};
  });
  const auto carried = carry_texture(square.input, texture, square.result, square.map);
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const bool right = position(square.input.mesh, square.result.face_points[i / 3]).x() > 6;
    CHECK(std::isfinite(carried[i][0]) == !right);
  }
}

}  // namespace gvd::test_carry_texture
