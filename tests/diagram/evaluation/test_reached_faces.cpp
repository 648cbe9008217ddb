#include "diagram/evaluation/reached_faces.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_reached_faces {

TEST_CASE("without a generator no face is reached") {
  const Mesh mesh = test::make_triangle();
  CHECK_FALSE(ReachedFaces(mesh, {}).contains(FaceId(0)));
}

TEST_CASE("one generator reaches its component, and no other") {
  const Mesh mesh = test::make_two_components();
  const FaceId last(mesh.face_count() - 1);
  const ReachedFaces first_only(mesh, {vertex_point(mesh, VertexId(0))});
  CHECK(first_only.contains(FaceId(0)));
  CHECK_FALSE(first_only.contains(last));
  const ReachedFaces last_only(mesh, {make_surface_point(last, {0.3, 0.3, 0.4})});
  CHECK_FALSE(last_only.contains(FaceId(0)));
  CHECK(last_only.contains(last));
  const ReachedFaces both(mesh, {vertex_point(mesh, VertexId(0)), make_surface_point(last, {0.3, 0.3, 0.4})});
  for (int f = 0; f < mesh.face_count(); ++f) REQUIRE(both.contains(FaceId(f)));
}

}  // namespace gvd::test_reached_faces
