#include "gvd/surface_normal.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_surface_normal {

TEST_CASE("surface normal: of a flat mesh the same unit vector everywhere") {
  const Mesh grid = test::make_grid(3, 2);
  for (const SurfacePoint& p : test::random_generators(grid, 30, 1)) {
    REQUIRE((surface_normal(grid, p) - Vec3(0, 0, 1)).norm() < 1e-14);
  }
}

TEST_CASE("surface normal: on an edge the mean of two faces, at a corner of a cube that of three by their angles") {
  const Mesh roof = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}});
  const SurfacePoint ridge = edge_point(Mesh::halfedge(FaceId(0), 0), 0.5);
  CHECK((surface_normal(roof, ridge) - Vec3(0, 1, 1).normalized()).norm() < 1e-14);
  // One of the three sides of a cube's corner has two faces there: the angles count, not the faces.
  const Mesh corner = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}},
                                      {{0, 1, 4}, {0, 4, 2}, {0, 2, 3}, {0, 3, 1}});
  CHECK((surface_normal(corner, vertex_point(corner, VertexId(0))) - Vec3(1, 1, 1).normalized()).norm() < 1e-14);
}

TEST_CASE("surface normal: of a sphere it points outwards") {
  const Mesh sphere = test::make_sphere(3);
  for (const SurfacePoint& p : test::random_generators(sphere, 60, 1)) {
    const Vec3 n = surface_normal(sphere, p);
    REQUIRE(n.norm() == Approx(1));
    REQUIRE(n.dot(position(sphere, p).normalized()) > 0.97);
  }
}

TEST_CASE("surface normal: zero where no face has an area") {
  const Mesh line = test::make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  CHECK(surface_normal(line, vertex_point(line, VertexId(0))) == Vec3(0, 0, 0));
  CHECK(surface_normal(line, make_surface_point(FaceId(0), {0.3, 0.3, 0.4})) == Vec3(0, 0, 0));
}

TEST_CASE("the normal of a face has length 1 or 0, and the angles of its corners sum to 180 degrees") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {2, 0, 0}, {0, 1e-3, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK(face_normal(mesh, FaceId(0)) == Vec3(0, 0, 1));
  CHECK(face_normal(mesh, FaceId(1)) == Vec3::Zero());
  for (const FaceId f : {FaceId(0), FaceId(1)}) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += corner_angle(mesh, Mesh::halfedge(f, i));
    CHECK(sum == Approx(3.14159265358979));
  }
  CHECK(corner_angle(mesh, Mesh::halfedge(FaceId(0), 0)) == Approx(1.570796326794897));
}

}  // namespace gvd::test_surface_normal
