#include "repair/added_generators.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_added_generators {

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
