#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "gvd/surface_point.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_surface_point {

TEST_CASE("the faces around a point are those that contain all corners it depends on, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (const SurfacePoint& p : test::random_generators(mesh, 60, 5)) {
      std::vector<FaceId> expected;
      for (int f = 0; f < mesh.face_count(); ++f) {
        const auto& corners = mesh.vertices(FaceId(f));
        // The corners that the point depends on all belong to the face.
        bool named = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const VertexId v = mesh.vertices(p.face)[i];
          named = named && (p.bary[i] == 0 || std::count(corners.begin(), corners.end(), v) > 0);
        }
        if (named) expected.push_back(FaceId(f));
      }
      std::vector<FaceId> found = faces_around(mesh, p);
      std::sort(found.begin(), found.end());
      REQUIRE(found == expected);
    }
  }
}

TEST_CASE("a point is on the boundary where its vertex or its edge is, and never inside a face") {
  const Mesh grid = test::make_grid(3, 3);
  const auto vertex = [&](int i, int j) { return vertex_point(grid, VertexId(j * 4 + i)); };
  CHECK(is_on_boundary(grid, vertex(0, 0)));
  CHECK(is_on_boundary(grid, vertex(2, 0)));
  CHECK_FALSE(is_on_boundary(grid, vertex(1, 2)));
  for (int e = 0; e < grid.edge_count(); ++e) {
    const HalfedgeId h = grid.halfedge(EdgeId(e));
    const Vec3 p = position(grid, edge_point(h, 0.5));
    const bool is_outer = p.x() == 0 || p.x() == 3 || p.y() == 0 || p.y() == 3;
    CHECK(is_on_boundary(grid, edge_point(h, 0.5)) == is_outer);
  }
  CHECK_FALSE(is_on_boundary(grid, make_surface_point(FaceId(0), {0.2, 0.3, 0.5})));
}

TEST_CASE("a value at a point is linear between its face's vertices, of which it leaves out those without weight") {
  const Mesh mesh = test::make_grid(1, 1);
  IdVector<VertexId, double> values(4, std::numeric_limits<double>::infinity());
  const auto& [a, b, c] = mesh.vertices(FaceId(0));
  values[a] = 1;
  values[b] = 3;
  CHECK(interpolate_at(mesh, values, make_surface_point(FaceId(0), {0.25, 0.75, 0})) == 2.5);
  CHECK(std::isinf(interpolate_at(mesh, values, make_surface_point(FaceId(0), {0.25, 0.5, 0.25}))));
  values[c] = 7;
  CHECK(interpolate_at(mesh, values, make_surface_point(FaceId(0), {0.25, 0.5, 0.25})) == 3.5);
}

}  // namespace gvd::test_surface_point
