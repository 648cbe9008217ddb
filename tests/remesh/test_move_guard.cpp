// Moves are halved, or left out, where they would break a triangle.
#include <algorithm>

#include "dual/self_intersections.hpp"
#include "gvd/dual.hpp"
#include "gvd/quality.hpp"
#include "move_guard.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_move_guard {

/// A mesh as the remesh of itself.
struct Copy {
  Mesh mesh;
  std::vector<SurfacePoint> generators, face_points;

  explicit Copy(Mesh given) : mesh(std::move(given)) {
    for (int v = 0; v < mesh.vertex_count(); ++v) generators.push_back(vertex_point(mesh, VertexId(v)));
    for (int f = 0; f < mesh.face_count(); ++f) {
      face_points.push_back(make_surface_point(FaceId(f), {0.25, 0.25, 0.5}));
    }
  }
  std::vector<Vec3> move(const std::vector<Vec3>& to, const PlacementOptions& options = {}) const {
    return MoveGuard(mesh, mesh, generators, face_points, options).move(mesh.positions(), to);
  }
  bool is_valid(const std::vector<Vec3>& positions, double least_angle) const {
    const Mesh moved = with_positions(mesh, positions);
    if (!find_flipped_faces(mesh, moved, generators, face_points).empty()) return false;
    return find_self_intersections(moved).empty() && compute_triangle_quality(moved).angle_min >= least_angle;
  }
};

TEST_CASE("a move that breaks nothing is made, bit by bit") {
  const Copy sphere(test::make_sphere(2));
  std::vector<Vec3> larger = sphere.mesh.positions();
  for (Vec3& p : larger) p *= 1.25;
  CHECK(sphere.move(larger) == larger);
  CHECK(sphere.move(sphere.mesh.positions()) == sphere.mesh.positions());
}

TEST_CASE("moves that flip, thin or cross triangles end where they are valid, for any number of threads") {
  PlacementOptions one, many;
  one.threads = 1;
  many.threads = 4;
  for (unsigned seed = 0; seed < 5; ++seed) {
    for (const Copy& copy : {Copy(test::make_sphere(2)), Copy(test::make_plate(6, 0.05))}) {
      test::Random random(seed);
      std::vector<Vec3> to = copy.mesh.positions();
      const double far = 1.5 * copy.mesh.mean_edge_length();
      for (Vec3& p : to) p += far * Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
      REQUIRE_FALSE(copy.is_valid(to, 0));
      const double before = compute_triangle_quality(copy.mesh).angle_min;
      const std::vector<Vec3> moved = copy.move(to, one);
      CHECK(copy.is_valid(moved, std::min(0.999 * before, one.least_angle)));
      CHECK(moved == copy.move(to, many));
    }
  }
}

TEST_CASE("one vertex goes through the opposite sheet only as far as it may") {
  const Copy plate(test::make_plate(6, 0.05));
  std::vector<Vec3> to = plate.mesh.positions();
  std::size_t inner = 0;  // on the upper sheet
  while (!(to[inner].z() > 0.04 && std::abs(to[inner].x() - 0.5) < 0.2 && std::abs(to[inner].y() - 0.5) < 0.2)) ++inner;
  to[inner].z() -= 0.09;
  const std::vector<Vec3> moved = plate.move(to);
  CHECK(plate.is_valid(moved, 0));
  CHECK(moved[inner].z() > 0);
  CHECK(moved[inner].z() < plate.mesh.positions()[inner].z());
}

TEST_CASE("loosened triangles may be thinner than the others") {
  const Copy sphere(test::make_sphere(2));
  test::Random random(1);
  std::vector<Vec3> to = sphere.mesh.positions();
  for (Vec3& p : to) p += sphere.mesh.mean_edge_length() * 0.6 * Vec3(random.real(-1, 1), random.real(-1, 1), 0);
  PlacementOptions options;
  MoveGuard guard(sphere.mesh, sphere.mesh, sphere.generators, sphere.face_points, options);
  CHECK(sphere.is_valid(guard.move(sphere.mesh.positions(), to), options.least_angle));
  std::vector<char> upper;
  for (const Vec3& p : sphere.mesh.positions()) upper.push_back(p.z() > 0.3);
  guard.loosen(upper, options.least_crease_angle);
  const Mesh moved = with_positions(sphere.mesh, guard.move(sphere.mesh.positions(), to));
  double least_above = 60, least_below = 60;
  for (std::int32_t f = 0; f < moved.face_count(); ++f) {
    const auto& [a, b, c] = moved.vertices(FaceId(f));
    const double angle = compute_min_angle(moved.position(a), moved.position(b), moved.position(c));
    double& least = upper[a.index()] || upper[b.index()] || upper[c.index()] ? least_above : least_below;
    least = std::min(least, angle);
  }
  CHECK(least_below >= options.least_angle);
  CHECK(least_above >= options.least_crease_angle);
  CHECK(least_above < options.least_angle);
}

}  // namespace gvd::test_move_guard
