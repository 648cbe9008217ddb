#include <array>
#include <cmath>

#include "geodesic/face_layout.hpp"
#include "gvd/surface_point.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_layout {

TEST_CASE("a face without area gets the least height, and finite coordinates") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, {{0, 1, 2}});
  const FaceLayout layout(mesh, FaceId(0));
  CHECK(layout.corner[2].y() == Approx(FaceLayout::kLeastHeight));
  CHECK(layout.twice_area > 0);
  for (const double b : layout.bary({0.25, 0})) CHECK(std::isfinite(b));
}

TEST_CASE("distances between the corners are the lengths of the edges, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (int f = 0; f < mesh.face_count(); ++f) {
      const FaceLayout layout(mesh, FaceId(f));
      for (int i = 0; i < 3; ++i) {
        const Vec2 side = layout.corner[std::size_t((i + 1) % 3)] - layout.corner[std::size_t(i)];
        REQUIRE(side.norm() == Approx(mesh.length(Mesh::halfedge(FaceId(f), i))).epsilon(1e-9));
        REQUIRE(layout.side(i).norm() == Approx(1).epsilon(1e-14));
      }
      REQUIRE(layout.twice_area == Approx(2 * mesh.area(FaceId(f))).epsilon(1e-9));
    }
  }
}

TEST_CASE("points and barycentric coordinates convert to each other, and change by the stated rate") {
  const FaceLayout layout(test::make_triangle(), FaceId(0));
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec2 p(random.real(-1, 3), random.real(-1, 2)), direction(random.real(-1, 1), random.real(-1, 1));
    const Bary bary = layout.bary(p), moved = layout.bary(p + direction), rate = layout.bary_rate(direction);
    REQUIRE((layout.at(bary) - p).norm() < 1e-14);
    for (std::size_t k = 0; k < 3; ++k) REQUIRE(moved[k] - bary[k] == Approx(rate[k]).epsilon(1e-12).margin(1e-13));
  }
}

TEST_CASE("a face with one short side is laid out with all digits of the long ones") {
  const std::array<Vec3, 3> corner{Vec3(0.1, 0.2, 0.3), Vec3(0.1 + 1e-7, 0.2 + 1e-7, 0.3), Vec3(0.7, 1.1, 0.4)};
  for (std::size_t first = 0; first < 3; ++first) {
    const Mesh mesh({corner[first], corner[(first + 1) % 3], corner[(first + 2) % 3]},
                    {std::array{VertexId(0), VertexId(1), VertexId(2)}});
    const FaceLayout layout(mesh, FaceId(0));
    for (std::size_t i = 0; i < 3; ++i) {
      const double length = mesh.length(Mesh::halfedge(FaceId(0), static_cast<int>(i)));
      CHECK(std::abs((layout.corner[(i + 1) % 3] - layout.corner[i]).norm() - length) < 1e-15);
    }
  }
}

TEST_CASE("locating in a face: a point of another face has no position") {
  const Mesh grid = test::make_grid(2, 1);
  CHECK_FALSE(locate_in_face(grid, FaceId(0), make_surface_point(FaceId(1), {0.2, 0.3, 0.5})));
  CHECK_FALSE(locate_in_face(grid, FaceId(2), vertex_point(grid, VertexId(0))));
  CHECK_FALSE(locate_in_face(grid, FaceId(2), edge_point(Mesh::halfedge(FaceId(0), 0), 0.5)));
}

TEST_CASE("locating in a face: two faces with the same corners share all points of their borders") {
  const Mesh pillow = test::make_pillow();
  const SurfacePoint p = edge_point(Mesh::halfedge(FaceId(0), 0), 0.25);
  const auto here = locate_in_face(pillow, FaceId(0), p), there = locate_in_face(pillow, FaceId(1), p);
  REQUIRE((here && there));
  CHECK(*here == Vec2(0.5, 0));
  CHECK(there->norm() == Approx(0.5));  // corner 0 of both faces is vertex 0
}

TEST_CASE("locating in a face: every view of a point gives the same position, at the right distances") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    for (const SurfacePoint& p : test::random_generators(mesh, 15, 3)) {
      const auto views = find_views(mesh, p);
      for (const SurfacePoint& view : views) {
        const FaceLayout layout(mesh, view.face);
        for (const SurfacePoint& named : views) {
          const auto at = locate_in_face(mesh, view.face, named);
          REQUIRE(at);
          CHECK((*at - layout.at(view.bary)).norm() < 1e-12);
        }
        for (std::size_t i = 0; i < 3; ++i) {
          const double distance = (mesh.position(mesh.vertices(view.face)[i]) - position(mesh, p)).norm();
          CHECK((layout.corner[i] - *locate_in_face(mesh, view.face, p)).norm() == Approx(distance).margin(1e-9));
        }
      }
    }
  }
}

}  // namespace gvd::test_face_layout
