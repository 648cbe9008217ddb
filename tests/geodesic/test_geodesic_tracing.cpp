#include <numbers>
#include <random>

#include "gvd/error.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_geodesic_tracing {

constexpr double kPi = std::numbers::pi;

double uniform(std::mt19937& random) { return double(random()) / double(std::mt19937::max()); }

/// The x axis of the tangent plane, in space; not for points on the boundary of two faces that aren't coplanar.
Vec3 tangent_x(const Mesh& mesh, const SurfacePoint& p) {
  HalfedgeId h = Mesh::halfedge(p.face, 0);
  if (p.kind() == SurfacePoint::Kind::edge) h = halfedge(p);
  if (p.kind() == SurfacePoint::Kind::vertex) h = mesh.halfedge(vertex(mesh, p));
  return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
}

/// A vector of the plane z = 0 as a tangent vector of a flat mesh.
Vec2 flat_tangent(const Mesh& mesh, const SurfacePoint& p, const Vec2& v) {
  const Vec3 x = tangent_x(mesh, p);
  return {v.x() * x.x() + v.y() * x.y(), v.y() * x.x() - v.x() * x.y()};
}

void require_sound(const Mesh& mesh, const GeodesicTrace& trace, double wanted) {
  double length = 0;
  for (std::size_t i = 0; i < trace.points.size(); ++i) {
    const SurfacePoint& p = trace.points[i];
    REQUIRE((p.face.valid() && p.face.value() < mesh.face_count()));
    const SurfacePoint same = make_surface_point(p.face, p.bary);
    for (std::size_t k = 0; k < 3; ++k) REQUIRE(same.bary[k] == Approx(p.bary[k]).margin(1e-12));
    if (i > 0) length += (position(mesh, p) - position(mesh, trace.points[i - 1])).norm();
  }
  REQUIRE(trace.length == Approx(length).margin(1e-9));
  REQUIRE(trace.length <= wanted * (1 + 1e-12));
  if (trace.complete) REQUIRE(trace.length == Approx(wanted).epsilon(1e-12));
  REQUIRE(trace.direction.norm() == Approx(1));
}

/// The vertex of the mesh nearest to a position.
SurfacePoint nearest_vertex(const Mesh& mesh, const Vec3& p) {
  VertexId best(0);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if ((mesh.position(VertexId(v)) - p).norm() < (mesh.position(best) - p).norm()) best = VertexId(v);
  }
  return vertex_point(mesh, best);
}

TEST_CASE("a zero tangent traces nothing") {
  const Mesh mesh = test::make_grid(2, 2);
  const SurfacePoint start = make_surface_point(FaceId(1), {0.2, 0.3, 0.5});
  const GeodesicTrace trace = trace_geodesic(mesh, start, Vec2::Zero());
  CHECK(trace.points == std::vector{start});
  CHECK(trace.length == 0);
  CHECK(trace.complete);
}

TEST_CASE("an invalid start or tangent of a geodesic is refused") {
  const Mesh mesh = test::make_grid(1, 1);
  CHECK_THROWS_AS(trace_geodesic(mesh, {FaceId(2), {1, 0, 0}}, Vec2(1, 0)), Error);
  CHECK_THROWS_AS(trace_geodesic(mesh, {FaceId(), {1, 0, 0}}, Vec2(1, 0)), Error);
  CHECK_THROWS_AS(trace_geodesic(mesh, {FaceId(0), {1, 0, 0}}, Vec2(NAN, 0)), Error);
}

TEST_CASE("on a plane a geodesic is the straight line, from a face, an edge or a vertex") {
  const Mesh mesh = test::make_grid(8, 8);
  std::mt19937 random(5);
  for (const SurfacePoint& start : test::random_generators(mesh, 90, 2)) {
    const Vec3 from = position(mesh, start);
    for (int k = 0; k < 8; ++k) {
      const Vec2 to(8 * uniform(random), 8 * uniform(random));
      const Vec2 v = to - from.head<2>();
      const GeodesicTrace trace = trace_geodesic(mesh, start, flat_tangent(mesh, start, v));
      require_sound(mesh, trace, v.norm());
      REQUIRE(trace.complete);
      REQUIRE((position(mesh, trace.points.back()).head<2>() - to).norm() < 1e-10);
      const Vec2 onward = flat_tangent(mesh, trace.points.back(), v.normalized());
      REQUIRE((trace.direction - onward).norm() < 1e-9);
    }
  }
}

TEST_CASE("a geodesic follows the lines of a grid through its vertices") {
  const Mesh mesh = test::make_grid(6, 6);
  const SurfacePoint start = nearest_vertex(mesh, Vec3(1, 2, 0));
  for (const Vec2& v : {Vec2(4, 0), Vec2(0, 3), Vec2(3, 3), Vec2(-1, 1), Vec2(2, -2), Vec2(2.5, 2.5)}) {
    const GeodesicTrace trace = trace_geodesic(mesh, start, flat_tangent(mesh, start, v));
    require_sound(mesh, trace, v.norm());
    CHECK((position(mesh, trace.points.back()) - Vec3(1 + v.x(), 2 + v.y(), 0)).norm() < 1e-12);
  }
}

TEST_CASE("a geodesic ends at the boundary") {
  const Mesh mesh = test::make_grid(4, 4);
  const SurfacePoint start = make_surface_point(FaceId(9), {0.2, 0.3, 0.5});
  const Vec3 from = position(mesh, start);
  const GeodesicTrace trace = trace_geodesic(mesh, start, flat_tangent(mesh, start, Vec2(0, 100)));
  require_sound(mesh, trace, 100);
  CHECK(!trace.complete);
  CHECK((position(mesh, trace.points.back()) - Vec3(from.x(), 4, 0)).norm() < 1e-12);
  CHECK(trace.points.back().kind() == SurfacePoint::Kind::edge);
  const GeodesicTrace further = trace_geodesic(mesh, trace.points.back(), trace.direction);
  CHECK(further.length == 0);
  CHECK(!further.complete);
}

TEST_CASE("an outward tangent at the boundary is projected to it") {
  const Mesh mesh = test::make_grid(4, 4);
  const SurfacePoint top = nearest_vertex(mesh, Vec3(2, 4, 0)), corner = nearest_vertex(mesh, Vec3(4, 4, 0));
  const auto slide = [&](const SurfacePoint& p, const Vec2& v) {
    const GeodesicTrace trace = trace_geodesic(mesh, p, project_to_surface(mesh, p, flat_tangent(mesh, p, v)));
    return Vec2((position(mesh, trace.points.back()) - position(mesh, p)).head<2>());
  };
  CHECK((slide(top, {0.3, 0.5}) - Vec2(0.3, 0)).norm() < 1e-12);
  CHECK((slide(top, {-0.4, 0.5}) - Vec2(-0.4, 0)).norm() < 1e-12);
  CHECK((slide(top, {0.3, -0.5}) - Vec2(0.3, -0.5)).norm() < 1e-12);
  CHECK(slide(corner, {0.3, 0.5}).norm() < 1e-12);
  CHECK((slide(corner, {-0.3, 0.5}) - Vec2(-0.3, 0)).norm() < 1e-12);
}

TEST_CASE("a geodesic round a cube crosses four faces and returns to its start") {
  const Mesh cube = test::make_plate(1, 1.0);
  for (int f = 0; f < cube.face_count(); ++f) {
    for (const std::array<double, 3>& bary : {std::array{0.3, 0.3, 0.4}, std::array{0.15, 0.7, 0.15}}) {
      const SurfacePoint start = make_surface_point(FaceId(f), bary);
      const Vec3 x = tangent_x(cube, start);
      // Halfedge 0 runs along the cube's edge or along the diagonal of a square.
      const double diagonal = cube.length(Mesh::halfedge(FaceId(f), 0)) > 1.1 ? kPi / 4 : 0;
      for (int side = 0; side < 4; ++side) {
        const double angle = diagonal + side * kPi / 2;
        const GeodesicTrace loop = trace_geodesic(cube, start, 4 * Vec2(std::cos(angle), std::sin(angle)));
        require_sound(cube, loop, 4);
        CAPTURE(f, side, x.transpose());
        CHECK((position(cube, loop.points.back()) - position(cube, start)).norm() < 1e-12);
      }
    }
  }
}

TEST_CASE("on a prism a geodesic is a helix of constant slope") {
  const int sides = 24;
  const Mesh ring = test::make_ring(sides, 6);
  const double width = 2 * std::sin(kPi / sides);
  for (const SurfacePoint& start : test::random_generators(ring, 30, 4)) {
    if (start.kind() != SurfacePoint::Kind::face) continue;
    const Vec3 from = position(ring, start), x = tangent_x(ring, start);
    const auto& [a, b, c] = ring.vertices(start.face);
    const Vec3 normal = (ring.position(b) - ring.position(a)).cross(ring.position(c) - ring.position(a)).normalized();
    const Vec3 round = Vec3(0, 0, 1).cross(normal);
    const double rise = (0.45 - from.z()) / 5;
    const Vec3 v = 5.0 * round + (0.45 - from.z()) * Vec3(0, 0, 1);
    const GeodesicTrace trace = trace_geodesic(ring, start, Vec2(v.dot(x), normal.dot(x.cross(v))));
    require_sound(ring, trace, v.norm());
    const Vec3 to = position(ring, trace.points.back());
    CHECK(to.z() == Approx(from.z() + 5 * rise).epsilon(1e-10));
    // Unrolled: whole sides passed, and the place on the side where it ends.
    const auto unrolled = [&](const Vec3& p) {
      const double side = std::floor(std::fmod(std::atan2(p.y(), p.x()) + 2 * kPi, 2 * kPi) / (2 * kPi / sides));
      const double u = 2 * kPi * side / sides;
      return side * width + (p.head<2>() - Vec2(std::cos(u), std::sin(u))).norm();
    };
    const double passed =
        std::remainder(unrolled(to) - unrolled(from) - 5 * round.dot(Vec3(0, 0, 1).cross(normal)), sides * width);
    CHECK(std::abs(passed) < 1e-10);
  }
}

TEST_CASE("on a fine sphere a geodesic follows the great circle") {
  const Mesh sphere = test::make_sphere(5);
  for (int k = 0; k < 7; ++k) {
    const SurfacePoint start = make_surface_point(FaceId(311 + 2000 * k), {0.3, 0.45, 0.25});
    const Vec3 from = position(sphere, start), x = tangent_x(sphere, start);
    const Vec3 y = from.normalized().cross(x).normalized();
    const double angle = 0.4 + k;
    const GeodesicTrace trace = trace_geodesic(sphere, start, 2.0 * Vec2(std::cos(angle), std::sin(angle)));
    require_sound(sphere, trace, 2);
    const Vec3 along = std::cos(angle) * x + std::sin(angle) * y;
    const Vec3 expected = std::cos(2.0) * from + std::sin(2.0) * along;
    CHECK((position(sphere, trace.points.back()) - expected).norm() < 0.02);
  }
}

TEST_CASE("a reversed geodesic returns to its start, on every family and with thin faces") {
  for (const auto& [name, mesh] : test::small_family()) {
    std::mt19937 random(11);
    for (const SurfacePoint& start : test::random_generators(mesh, 60, 9)) {
      if (mesh.is_boundary(VertexId(mesh.vertices(start.face)[0]))) continue;
      const double angle = 2 * kPi * uniform(random);
      const double length = 0.7 * mesh.bbox_diagonal();
      const GeodesicTrace there = trace_geodesic(mesh, start, length * Vec2(std::cos(angle), std::sin(angle)));
      INFO(name << ", face " << start.face.value() << ", angle " << angle);
      require_sound(mesh, there, length);
      if (there.length == 0) continue;
      const GeodesicTrace back = trace_geodesic(mesh, there.points.back(), -there.length * there.direction);
      CHECK((position(mesh, back.points.back()) - position(mesh, start)).norm() < 1e-6 * mesh.bbox_diagonal());
      CHECK(trace_geodesic(mesh, start, length * Vec2(std::cos(angle), std::sin(angle))).points == there.points);
    }
  }
}

TEST_CASE("a geodesic crosses faces without area") {
  // Two faces without area between two squares' halves: a T-shaped point on the line x = 1.
  std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0.5, 0}, {2, 0.5, 0}};
  const auto face = [](int a, int b, int c) { return std::array{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh mesh(positions, {face(0, 1, 2), face(2, 1, 3), face(1, 4, 3), face(3, 4, 2)});
  const SurfacePoint start = make_surface_point(FaceId(0), {0.5, 0.3, 0.2});
  const GeodesicTrace trace = trace_geodesic(mesh, start, Vec2(0.8, 0));
  require_sound(mesh, trace, 0.8);
  CHECK((position(mesh, trace.points.back()) - position(mesh, start) - Vec3(0.8, 0, 0)).norm() < 1e-9);
}

}  // namespace gvd::test_geodesic_tracing
