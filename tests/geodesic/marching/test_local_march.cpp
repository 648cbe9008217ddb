#include <cmath>

#include "geodesic/marching/fast_marching.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_local_march {

SurfacePoint point_in(FaceId f) { return make_surface_point(f, {0.2, 0.3, 0.5}); }

TEST_CASE("before the first run nothing is reached") {
  const Mesh mesh = test::make_triangle();
  const LocalMarch march(mesh, Front::circle);
  CHECK(march.reached().empty());
}

TEST_CASE("in the faces of the start distances are straight, from a vertex, an edge and a face") {
  const Mesh mesh = test::make_pillow();
  LocalMarch march(mesh, Front::circle);
  for (const SurfacePoint& start :
       {vertex_point(mesh, VertexId(1)), edge_point(Mesh::halfedge(FaceId(0), 1), 0.25), point_in(FaceId(0))}) {
    march.run(start, kInfinity);
    for (int v = 0; v < 3; ++v) {
      CHECK(march.distance(VertexId(v)) == Approx((mesh.position(VertexId(v)) - position(mesh, start)).norm()));
    }
    CHECK(march.distance(start) == Approx(0).margin(1e-12));
  }
}

TEST_CASE("with circle fronts distances on a flat grid are straight, at vertices and inside of faces") {
  const Mesh mesh = test::make_grid(9, 7);
  LocalMarch march(mesh, Front::circle);
  for (const SurfacePoint& start : {vertex_point(mesh, VertexId(34)), point_in(FaceId(50))}) {
    march.run(start, kInfinity);
    CHECK(march.reached().size() == static_cast<std::size_t>(mesh.vertex_count()));
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const double straight = (mesh.position(VertexId(v)) - position(mesh, start)).norm();
      REQUIRE(march.distance(VertexId(v)) == Approx(straight).epsilon(1e-10));
    }
    for (int f = 0; f < mesh.face_count(); ++f) {
      const SurfacePoint p = point_in(FaceId(f));
      REQUIRE(march.distance(p) == Approx((position(mesh, p) - position(mesh, start)).norm()).epsilon(1e-10));
    }
  }
}

TEST_CASE("a run stops at its limit: beyond it only the ring of vertices is reached") {
  const Mesh mesh = test::make_grid(30, 30);
  LocalMarch march(mesh, Front::circle);
  const SurfacePoint start = vertex_point(mesh, VertexId(15 * 31 + 15));
  march.run(start, 3);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double straight = (mesh.position(VertexId(v)) - position(mesh, start)).norm();
    if (straight < 3) REQUIRE(march.distance(VertexId(v)) == Approx(straight).epsilon(1e-10));
    if (straight > 3 + 2 * std::sqrt(2)) REQUIRE(std::isinf(march.distance(VertexId(v))));
  }
  CHECK(std::isinf(march.distance(point_in(FaceId(0)))));
}

TEST_CASE("a vertex that is nearer to something else does not propagate") {
  const Mesh mesh = test::make_grid(20, 20);
  LocalMarch march(mesh, Front::circle);
  // The left half belongs to others.
  IdVector<VertexId, double> upper(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.position(VertexId(v)).x() < 10) upper[VertexId(v)] = 0;
  }
  march.run(vertex_point(mesh, VertexId(10 * 21 + 15)), kInfinity, &upper);
  for (const VertexId v : march.reached()) REQUIRE(mesh.position(v).x() >= 9);
  CHECK(march.reached().size() >= 11 * 21);
}

TEST_CASE("a second run does not depend on the first one") {
  const Mesh mesh = test::make_bumpy_sphere(2, 4);
  LocalMarch used(mesh, Front::circle), fresh(mesh, Front::circle);
  used.run(vertex_point(mesh, VertexId(0)), kInfinity);
  const SurfacePoint start = point_in(FaceId(20));
  used.run(start, 0.7);
  fresh.run(start, 0.7);
  CHECK(used.reached() == fresh.reached());
  for (int v = 0; v < mesh.vertex_count(); ++v) REQUIRE(used.distance(VertexId(v)) == fresh.distance(VertexId(v)));
}

}  // namespace gvd::test_local_march
