#include <algorithm>
#include <random>

#include "gvd/error.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "gvd/log_map.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_log_map {

/// The plane z = 0 turned so that the tangent plane's x axis is its own.
Vec2 flat_tangent(const Mesh& mesh, const SurfacePoint& p, const Vec3& v) {
  HalfedgeId h = Mesh::halfedge(p.face, 0);
  if (p.kind() == SurfacePoint::Kind::edge) h = halfedge(p);
  if (p.kind() == SurfacePoint::Kind::vertex) h = mesh.halfedge(vertex(mesh, p));
  const Vec3 x = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
  return {v.dot(x), v.y() * x.x() - v.x() * x.y()};
}

double largest_flat_error(const Mesh& mesh, const SurfacePoint& origin, const std::vector<FaceId>& faces,
                          const LogMap& map) {
  double largest = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 difference = mesh.position(mesh.vertices(faces[i])[k]) - position(mesh, origin);
      largest = std::max(largest, (map.corners[i][k] - flat_tangent(mesh, origin, difference)).norm());
    }
  }
  return largest;
}

std::vector<FaceId> all_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  for (int f = 0; f < mesh.face_count(); ++f) faces.emplace_back(f);
  return faces;
}

/// A flat grid whose inner vertices are moved about, so that some triangles are obtuse.
Mesh make_crooked_grid(int n, double shift) {
  const Mesh grid = test::make_grid(n, n);
  std::vector<Vec3> positions = grid.positions();
  std::mt19937 random(3);
  for (Vec3& p : positions) {
    const double x = double(random()) / double(std::mt19937::max()), y = double(random()) / double(std::mt19937::max());
    const Vec3 move(x - 0.5, y - 0.5, 0);
    if (p.x() > 0 && p.x() < n && p.y() > 0 && p.y() < n) p += shift * move;
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < grid.face_count(); ++f) faces.push_back(grid.vertices(FaceId(f)));
  return Mesh(positions, faces);
}

TEST_CASE("on a flat grid the log map is the Euclidean difference") {
  const Mesh mesh = test::make_grid(9, 7);
  for (const SurfacePoint& origin : test::random_generators(mesh, 60, 1)) {
    const LogMap map = compute_log_map(mesh, origin);
    CHECK(map.complete);
    CHECK(largest_flat_error(mesh, origin, all_faces(mesh), map) < 1e-9);
  }
}

TEST_CASE("the log map is the Euclidean difference on a flat mesh with obtuse triangles, too") {
  for (const double shift : {0.2, 0.4, 0.6}) {
    CAPTURE(shift);
    const Mesh mesh = make_crooked_grid(12, shift);
    for (const SurfacePoint& origin : test::random_generators(mesh, 40, 6)) {
      CHECK(largest_flat_error(mesh, origin, all_faces(mesh), compute_log_map(mesh, origin)) < 1e-9);
    }
  }
}

TEST_CASE("the log map of a patch is that of the whole mesh, and one solver computes many") {
  const Mesh mesh = test::make_sphere(3);
  LogMapSolver solver(mesh);
  for (const SurfacePoint& origin : test::random_generators(mesh, 20, 8)) {
    const LogMap whole = compute_log_map(mesh, origin);
    std::vector<FaceId> near;
    for (int f = 0; f < mesh.face_count(); ++f) {
      if (whole.corners[std::size_t(f)][0].norm() < 0.6) near.emplace_back(f);
    }
    const LogMap patch = solver.compute(origin, near);
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK((patch.corners[i][k] - whole.corners[near[i].index()][k]).norm() < 2e-3);
      }
    }
  }
}

TEST_CASE("on a sphere the log map is close to the analytic one") {
  const Mesh mesh = test::make_sphere(4);
  for (const SurfacePoint& origin : {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(900)),
                                     make_surface_point(FaceId(4000), {0.3, 0.3, 0.4})}) {
    const LogMap map = compute_log_map(mesh, origin);
    const Vec3 pole = position(mesh, origin).normalized();
    const HalfedgeId h = origin.kind() == SurfacePoint::Kind::vertex ? mesh.halfedge(vertex(mesh, origin))
                                                                     : Mesh::halfedge(origin.face, 0);
    Vec3 x = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
    x = (x - x.dot(pole) * pole).normalized();
    const Vec3 y = pole.cross(x);
    for (int f = 0; f < mesh.face_count(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = mesh.position(mesh.vertices(FaceId(f))[k]);
        const double distance = std::acos(std::clamp(p.dot(pole), -1.0, 1.0));
        if (distance > 1.6) continue;  // errors grow towards the antipode, where directions run together
        const Vec2 expected = distance * Vec2(p.dot(x), p.dot(y)).normalized();
        if (distance < 1e-9) continue;
        CHECK((map.corners[std::size_t(f)][k] - expected).norm() < 0.02 * (0.2 + distance));
      }
    }
  }
}

TEST_CASE("tracing the log map's vectors ends at the vertices") {
  const Mesh mesh = test::make_bumpy_sphere(4, 7);
  for (const SurfacePoint& origin : test::random_generators(mesh, 9, 4)) {
    const LogMap map = compute_log_map(mesh, origin);
    for (int f = 0; f < mesh.face_count(); f += 7) {
      const Vec2 v = map.corners[std::size_t(f)][0];
      if (v.norm() > 0.4 || v.norm() == 0) continue;
      const Vec3 end = position(mesh, trace_geodesic(mesh, origin, v).points.back());
      CHECK((end - mesh.position(mesh.vertices(FaceId(f))[0])).norm() < 0.1 * v.norm());
    }
  }
}

TEST_CASE("log map: corners without a path are infinite, and a face that does not exist is refused") {
  const Mesh mesh = test::make_two_components();
  const LogMap map = compute_log_map(mesh, vertex_point(mesh, VertexId(0)));
  CHECK(!map.complete);
  CHECK(std::isinf(map.corners.back()[0].norm()));
  CHECK_THROWS_AS(compute_log_map(mesh, {FaceId(mesh.face_count()), {1, 0, 0}}), Error);
}

}  // namespace gvd::test_log_map
