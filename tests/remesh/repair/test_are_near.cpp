// Nearness along the surface: what lies in one place in space may be far apart.
#include "repair/are_near.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_are_near {

TEST_CASE("are near: on a flat grid the radius decides, across edges and vertices") {
  const Mesh grid = test::make_grid(4, 4);
  const auto at = [](int v, const Mesh& mesh) { return vertex_point(mesh, VertexId(v)); };
  CHECK(are_near(grid, at(6, grid), at(6, grid), 0));
  CHECK(are_near(grid, at(6, grid), at(7, grid), 1));
  CHECK_FALSE(are_near(grid, at(6, grid), at(7, grid), 0.99));
  CHECK(are_near(grid, at(6, grid), at(8, grid), 2));
  CHECK(are_near(grid, at(0, grid), at(24, grid), 5.7));
  CHECK_FALSE(are_near(grid, at(0, grid), at(24, grid), 5.6));
  const SurfacePoint below = make_surface_point(FaceId(0), {0.4, 0.3, 0.3});
  const SurfacePoint above = make_surface_point(FaceId(1), {0.4, 0.3, 0.3});
  const double apart = (position(grid, below) - position(grid, above)).norm();
  CHECK(are_near(grid, below, above, 1.01 * apart));
  CHECK_FALSE(are_near(grid, below, above, 0.99 * apart));
}

TEST_CASE("are near: the banks of a seam are far apart until the radius reaches round the tube") {
  const Mesh tube = test::make_cut_tube(4, 1, 2);
  const SurfacePoint left = vertex_point(tube, VertexId(1)), right = vertex_point(tube, VertexId(9));
  REQUIRE(position(tube, left) == position(tube, right));
  CHECK_FALSE(are_near(tube, left, right, 1e-6));
  CHECK_FALSE(are_near(tube, left, right, 1));
  CHECK(are_near(tube, left, right, 2));
}

TEST_CASE("are near: both banks are near at the inner end of a slit") {
  // A fan of six faces round vertex 0 that is cut open along the edge from 0 to 1; vertex 7 is the other bank.
  const Mesh fan =
      test::make_mesh({{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}, {2, 0, 0}},
                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}});
  const auto on_banks = [&](double t) {
    return std::pair(edge_point(Mesh::halfedge(FaceId(0), 0), t), edge_point(Mesh::halfedge(FaceId(5), 2), 1 - t));
  };
  const auto [near_left, near_right] = on_banks(0.25);
  REQUIRE((position(fan, near_left) - position(fan, near_right)).norm() < 1e-15);
  CHECK(are_near(fan, near_left, near_right, 0.5));
  CHECK_FALSE(are_near(fan, near_left, near_right, 0.4));
}

}  // namespace gvd::test_are_near
