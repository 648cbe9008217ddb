// Nearness along the surface: what lies in one place in space may be far apart. New generators keep their distance.
#include "repair/added_generators.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_added_generators {

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

SurfacePoint on_bottom(double x) { return edge_point(Mesh::halfedge(FaceId(0), 0), x); }

TEST_CASE("added generators: none where none may be added") {
  const Mesh grid = test::make_grid(2, 2);
  AddedGenerators added(grid, {vertex_point(grid, VertexId(0))}, 0);
  CHECK(added.is_full());
  CHECK_FALSE(added.add(vertex_point(grid, VertexId(8))));
  CHECK(added.take().empty());
}

TEST_CASE("added generators: a point on or too close to another one is not added") {
  const Mesh grid = test::make_grid(1, 1);
  const double spacing = kMinAddedSpacing * grid.bbox_diagonal();
  AddedGenerators added(grid, {vertex_point(grid, VertexId(0))}, 5);
  CHECK_FALSE(added.add(vertex_point(grid, VertexId(0))));
  CHECK_FALSE(added.add(on_bottom(0.9 * spacing)));
  CHECK(added.add(on_bottom(0.5)));
  CHECK_FALSE(added.add(on_bottom(0.5 + 0.9 * spacing)));
  CHECK(added.add(on_bottom(0.5 + 1.1 * spacing)));
  CHECK(added.size() == 2);
  CHECK(added.take() == std::vector<SurfacePoint>{on_bottom(0.5), on_bottom(0.5 + 1.1 * spacing)});
}

TEST_CASE("added generators: another component's generators don't count") {
  const Mesh mesh =
      test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  AddedGenerators added(mesh, {vertex_point(mesh, VertexId(0))}, 5);
  CHECK(std::isinf(added.clearance(vertex_point(mesh, VertexId(3)))));
  CHECK(added.add(vertex_point(mesh, VertexId(3))));
  CHECK(added.clearance(vertex_point(mesh, VertexId(1))) == 1);
}

TEST_CASE("added generators: a generator on the other bank of a seam does not count at its own position") {
  const Mesh tube = test::make_cut_tube(4, 1, 2);
  const SurfacePoint left = vertex_point(tube, VertexId(0)), right = vertex_point(tube, VertexId(8));
  REQUIRE(position(tube, left) == position(tube, right));
  AddedGenerators added(tube, {left}, 5);
  CHECK(added.clearance(left) == 0);
  CHECK(std::isinf(added.clearance(right)));
  CHECK(added.clearance(vertex_point(tube, VertexId(9))) == 2);
  CHECK(added.add(right));
  CHECK_FALSE(added.add(right));
}

TEST_CASE("added generators: the best candidate that is free is added, and the first of equals") {
  const Mesh grid = test::make_grid(1, 1);
  AddedGenerators added(grid, {vertex_point(grid, VertexId(1))}, 2);
  const auto x = [&](const SurfacePoint& p) { return position(grid, p).x(); };
  const std::vector<SurfacePoint> candidates{on_bottom(0.25), on_bottom(1), on_bottom(0.75)};
  CHECK(added.add_best(candidates, x));  // x = 1 is taken
  CHECK(added.clearance(on_bottom(0.75)) == 0);
  CHECK(added.add_best(candidates, [](const SurfacePoint&) { return 0.0; }));
  CHECK(added.take() == std::vector<SurfacePoint>{on_bottom(0.75), on_bottom(0.25)});
  CHECK_FALSE(AddedGenerators(grid, {}, 1).add_best({}, x));
}

}  // namespace gvd::test_added_generators
