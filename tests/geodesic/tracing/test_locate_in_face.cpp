#include "geodesic/tracing/locate_in_face.hpp"
#include "gvd/surface_point.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_locate_in_face {

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

}  // namespace gvd::test_locate_in_face
