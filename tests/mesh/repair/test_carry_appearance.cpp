// Texture coordinates and materials through every repair: each corner keeps those of its own polygon.
#include <cmath>

#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_carry_appearance {

using namespace test;

/// A soup whose corner c has the texture coordinates (c, 0.5), and polygon p the material p.
PolygonSoup make_textured(std::vector<Vec3> positions, const std::vector<std::vector<std::int32_t>>& polygons) {
  PolygonSoup soup;
  soup.positions = std::move(positions);
  for (const auto& polygon : polygons) {
    for (const std::int32_t v : polygon) {
      soup.appearance.texture.push_back({static_cast<double>(soup.corners.size()), 0.5});
      soup.corners.push_back(v);
    }
    soup.appearance.material.push_back(static_cast<std::int32_t>(soup.polygon_count()));
    soup.appearance.materials.push_back("m" + std::to_string(soup.polygon_count()));
    soup.close_polygon();
  }
  return soup;
}

const std::vector<Vec3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// Requires that each corner has the texture coordinates of the corner of its polygon at the same position.
CheckedMesh require_carried(const PolygonSoup& soup) {
  CheckedMesh checked = build_mesh(soup);
  const Mesh& mesh = checked.mesh;
  REQUIRE(checked.appearance.texture.size() == static_cast<std::size_t>(mesh.halfedge_count()));
  REQUIRE(checked.appearance.material.size() == static_cast<std::size_t>(mesh.face_count()));
  for (const HalfedgeId h : mesh.halfedges()) {
    const std::int32_t polygon = checked.input_polygon[Mesh::face(h)];
    const Uv& uv = checked.appearance.texture[h.index()];
    CHECK(checked.appearance.material[Mesh::face(h).index()] == polygon);
    if (checked.input_vertex[mesh.from(h)] < 0) continue;
    const auto corner = static_cast<std::size_t>(uv[0]);
    REQUIRE((soup.first_corner[polygon] <= corner && corner < soup.first_corner[polygon + 1]));
    CHECK(soup.positions[soup.corners[corner]] == mesh.position(mesh.from(h)));
  }
  return checked;
}

TEST_CASE("appearance: polygons are cut into triangles with their own corners") {
  CHECK(require_carried(make_textured(kSquare, {{0, 1, 2, 3}})).mesh.face_count() == 2);
  const std::vector<Vec3> arrow{{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}};
  CHECK(require_carried(make_textured(arrow, {{0, 1, 2, 3}, {2, 1, 4}, {2, 4, 3}})).mesh.face_count() == 4);
}

TEST_CASE("appearance: welded, flipped, repeated and removed corners and faces") {
  PolygonSoup apart =
      make_textured({kSquare[0], kSquare[1], kSquare[2], kSquare[0], kSquare[2], kSquare[3]}, {{0, 1, 2}, {3, 4, 5}});
  apart.unwelded = true;
  CHECK(require_carried(apart).mesh.vertex_count() == 4);
  require_carried(make_textured(kSquare, {{0, 1, 2}, {2, 0, 3}, {3, 0, 2}, {0, 3, 2}}));  // duplicates, one flipped
  require_carried(make_textured(kSquare, {{0, 0, 1}, {0, 1, 1, 2}, {0, 2, 3, 3}}));
  std::vector<Vec3> doubled = kSquare;
  doubled.push_back(kSquare[2]);
  require_carried(make_textured(doubled, {{0, 1, 2, 4}, {0, 4, 3}}));  // an edge of length 0
}

TEST_CASE("appearance: vertices that are cut apart keep the coordinates of their own faces") {
  // Three faces at an edge, of which one is cut off, and two fans at a vertex.
  const std::vector<Vec3> fin{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  CHECK(require_carried(make_textured(fin, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})).mesh.vertex_count() > 5);
  const std::vector<Vec3> fans{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  CHECK(require_carried(make_textured(fans, {{0, 1, 2}, {0, 3, 4}})).mesh.vertex_count() == 6);
  // The same with vertices of its own for each face: welded, then cut.
  PolygonSoup apart = make_textured({fans[0], fans[1], fans[2], fans[0], fans[3], fans[4]}, {{0, 1, 2}, {3, 4, 5}});
  apart.unwelded = true;
  CHECK(require_carried(apart).mesh.vertex_count() == 6);
}

/// The squares of full cubes that have no full cube on their other side.
PolygonSoup surface_of_cubes(const std::vector<std::array<int, 3>>& cubes) {
  std::vector<Vec3> positions;
  std::vector<std::vector<std::int32_t>> squares;
  const auto number = [](int x, int y, int z) { return x + 4 * (y + 4 * z); };
  for (int i = 0; i < 64; ++i) positions.emplace_back(i % 4, i / 4 % 4, i / 16);
  const auto is_full = [&](const std::array<int, 3>& cube) {
    return std::find(cubes.begin(), cubes.end(), cube) != cubes.end();
  };
  for (const std::array<int, 3>& cube : cubes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> other = cube, corner = cube;
        other[axis] += side == 1 ? 1 : -1;
        corner[axis] += side;
        if (is_full(other)) continue;
        std::vector<std::int32_t>& square = squares.emplace_back();
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const auto& [du, dv] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
          std::array<int, 3> at = corner;
          at[u] += du;
          at[v] += dv;
          square.push_back(number(at[0], at[1], at[2]));
        }
        if (side == 0) std::reverse(square.begin(), square.end());
      }
    }
  }
  return make_textured(std::move(positions), squares);
}

TEST_CASE("appearance: the midpoint of a split edge has the mean of its ends in each face") {
  // Two cubes that touch in an edge, joined round both of its ends: the edge is split by a vertex.
  const PolygonSoup soup =
      surface_of_cubes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}});
  const CheckedMesh checked = require_carried(soup);
  REQUIRE(checked.defects.split_edges == 1);
  const Vec3 low(1, 1, 1), high(1, 1, 2);
  int found = 0;
  for (const HalfedgeId h : checked.mesh.halfedges()) {
    if (checked.input_vertex[checked.mesh.from(h)] >= 0) continue;
    double sum = 0;
    int ends = 0;
    for (const std::size_t c : {0, 1, 2, 3}) {
      const std::size_t corner = soup.first_corner[checked.input_polygon[Mesh::face(h)]] + c;
      const Vec3& at = soup.positions[soup.corners[corner]];
      if (at != low && at != high) continue;
      sum += soup.appearance.texture[corner][0];
      ++ends;
    }
    REQUIRE(ends == 2);
    CHECK(checked.appearance.texture[h.index()] == Uv{sum / 2, 0.5});
    ++found;
  }
  CHECK(found == 4);  // two faces are split in two each
}

TEST_CASE("appearance: corners without coordinates have none, and a soup without stays without") {
  PolygonSoup soup = make_textured(kSquare, {{0, 1, 2}, {0, 2, 3}});
  soup.appearance.texture[4] = kNoTexture;
  const CheckedMesh checked = build_mesh(soup);
  for (std::size_t i = 0; i < 6; ++i) CHECK(is_finite(checked.appearance.texture[i]) == (i != 4));
  soup.appearance = {};
  CHECK(build_mesh(soup).appearance.empty());
}

TEST_CASE("appearance: a soup with too few entries is refused") {
  const auto refused = [](const PolygonSoup& soup) {
    return refusal([&] { build_mesh(soup); }, ErrorCode::precondition);
  };
  PolygonSoup soup = make_textured(kSquare, {{0, 1, 2}, {0, 2, 3}});
  soup.appearance.texture.pop_back();
  CHECK_THAT(refused(soup), Catch::Matchers::Contains("no texture coordinate for each corner"));
  soup = make_textured(kSquare, {{0, 1, 2}, {0, 2, 3}});
  soup.appearance.materials.pop_back();
  CHECK_THAT(refused(soup), Catch::Matchers::Contains("has no name"));
}

}  // namespace gvd::test_carry_appearance
