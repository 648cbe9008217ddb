// Slopes of the energy at a vertex, from the angles of the paths that leave it.
// Generators that rest at vertices, where the energy has no gradient that vanishes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "gvd/geodesic_tracing.hpp"
#include "gvd/lloyd.hpp"
#include "lloyd/states.hpp"
#include "relaxation_state.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_vertex_rests {

using std::numbers::pi;

std::vector<DepartingPath> random_paths(double total, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<DepartingPath> paths;
  for (int i = 0; i < 200; ++i) {
    const double at = share(random);
    paths.push_back({total * at * at, share(random)});
  }
  return paths;
}

/// The sum of the definition, path by path.
double slope_by_definition(double total, bool is_closed, const std::vector<DepartingPath>& paths, double direction) {
  double sum = 0;
  for (const DepartingPath& path : paths) {
    double between = std::abs(path.angle - direction);
    if (is_closed) between = std::min(between, total - between);
    sum += -2 * path.weight * std::cos(std::min(between, pi));
  }
  return sum;
}

TEST_CASE("vertex slope: every direction has the sum over all paths, on cones, planes, saddles and boundaries") {
  for (const double total : {0.5, 2.0, pi, 5.0, 2 * pi, 7.0, 3 * pi, 16.0}) {
    for (const bool is_closed : {true, false}) {
      const std::vector<DepartingPath> paths = random_paths(total, 1);
      const VertexSlope slope(total, is_closed, paths);
      double least = 1e9;
      for (int k = 0; k < 500; ++k) {
        CAPTURE(total, is_closed, k);
        const double direction = total * k / 500;
        const double expected = slope_by_definition(total, is_closed, paths, direction);
        CHECK(slope.at(direction) == Approx(expected).margin(1e-9));
        least = std::min(least, expected);
      }
      const VertexSlope::Least found = slope.least();
      CHECK(found.slope <= least + 1e-9);
      const double angle = is_closed ? found.angle - total * std::floor(found.angle / total) : found.angle;
      CHECK(found.slope == Approx(slope_by_definition(total, is_closed, paths, angle)).margin(1e-9));
    }
  }
}

TEST_CASE("vertex slope: in the plane it is the gradient, and a saddle can hold what comes from all sides") {
  const VertexSlope plane(2 * pi, true, {{0.5, 2}, {2, 1}});
  const Vec2 pull = 2 * Vec2(std::cos(0.5), std::sin(0.5)) + Vec2(std::cos(2), std::sin(2));
  CHECK(plane.least().slope == Approx(-2 * pull.norm()));
  CHECK(plane.least().angle == Approx(std::atan2(pull.y(), pull.x())));
  std::vector<DepartingPath> all_round;
  for (int i = 0; i < 90; ++i) all_round.push_back({3 * pi * i / 90, 1});
  CHECK(VertexSlope(3 * pi, true, all_round).least().slope > 0);
  CHECK(VertexSlope(2 * pi, true, {}).least().slope == 0);
}

using test::evaluate_state;

/// A disc round vertex 0, whose rim rises and falls: 6 turns of a height, the higher the more angle about the vertex.
Mesh make_saddle(double height) {
  std::vector<Vec3> positions = {{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  const int sides = 12;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    positions.push_back({std::cos(angle), std::sin(angle), i % 2 == 0 ? height : -height});
    faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
  }
  return test::make_mesh(positions, faces);
}

bool rests_at(const Mesh& mesh, VertexId v) {
  const RelaxationState state = evaluate_state(mesh, {vertex_point(mesh, v)});
  CHECK((state.is_resting[0] != 0) == (state.to_centroids[0] == Vec2::Zero()));
  return state.is_resting[0] != 0;
}

double nearest_distance(const Mesh& mesh, const std::vector<SurfacePoint>& points, const Vec3& to) {
  double least = 1e9;
  for (const SurfacePoint& p : points) least = std::min(least, (position(mesh, p) - to).norm());
  return least;
}

double energy_of(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return evaluate_state(mesh, generators).energy;
}

TEST_CASE("vertex rests: a generator rests at a saddle, not at the tip of a cone, nor at a corner of a square") {
  CHECK(rests_at(make_saddle(0.3), VertexId(0)));
  CHECK(rests_at(make_saddle(2), VertexId(0)));
  CHECK_FALSE(rests_at(test::make_pyramid(270, 12), VertexId(0)));
  CHECK_FALSE(rests_at(test::make_grid(4, 4), VertexId(0)));
}

TEST_CASE("vertex rests: the way from a vertex is the steepest one, and its length gives the slope") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (int i = 3; i < mesh.vertex_count(); i += 83) {
      CAPTURE(name, i);
      const VertexId v(i);
      if (!mesh.halfedge(v).valid()) continue;
      std::vector<SurfacePoint> generators = test::random_generators(mesh, 4, 1);
      if (nearest_distance(mesh, generators, mesh.position(v)) < 0.2) continue;
      generators.push_back(vertex_point(mesh, v));
      const RelaxationState state = evaluate_state(mesh, generators);
      // The quadrature's error changes when the generator leaves the vertex, so steps must not be too short.
      const double mass = state.moments[GeneratorId(4)].mass, h = 0.01 * state.mean_cell_radius;
      const double scale = 2 * mass * state.mean_cell_radius;
      const Vec2 way = state.to_centroids[4];
      double least = 0;
      for (int k = 0; k < 8; ++k) {
        const Vec2 step = h * Vec2(std::cos(k * std::numbers::pi / 4), std::sin(k * std::numbers::pi / 4));
        generators[4] = trace_geodesic(mesh, vertex_point(mesh, v), step).points.back();
        least = std::min(least, (energy_of(mesh, generators) - state.energy) / h);
      }
      CHECK(1.2 * 2 * mass * way.norm() >= -least - 0.05 * scale);
      if (way == Vec2::Zero()) continue;
      generators[4] = trace_geodesic(mesh, vertex_point(mesh, v), h * way.normalized()).points.back();
      CHECK((energy_of(mesh, generators) - state.energy) / h ==
            Approx(-2 * mass * way.norm()).epsilon(0.2).margin(0.05 * scale));
    }
  }
}

TEST_CASE("vertex rests: a saddle on the way to the centroid is found, and other vertices are not") {
  const Mesh mesh = make_saddle(0.3);
  const RelaxationState beside = evaluate_state(mesh, {make_surface_point(FaceId(3), {0.98, 0.01, 0.01})});
  CHECK(beside.rest[0] == VertexId(0));
  CHECK_FALSE(evaluate_state(mesh, {make_surface_point(FaceId(3), {0.5, 0.25, 0.25})}).rest[0]);
  CHECK_FALSE(evaluate_state(test::make_grid(4, 4), {make_surface_point(FaceId(13), {0.98, 0.01, 0.01})}).rest[0]);
  CHECK_FALSE(evaluate_state(test::make_pyramid(270, 12), {make_surface_point(FaceId(3), {0.98, 0.01, 0.01})}).rest[0]);
}

TEST_CASE("vertex rests: relaxation ends at the saddle, whichever side it starts from") {
  for (const double height : {0.2, 0.5, 1.0}) {
    const Mesh mesh = make_saddle(height);
    for (int face = 0; face < mesh.face_count(); ++face) {
      CAPTURE(height, face);
      LloydOptions options;
      options.energy_tolerance = 0;
      const LloydResult result = relax_generators(mesh, {make_surface_point(FaceId(face), {0.7, 0.2, 0.1})}, options);
      CHECK(result.stop == LloydStop::centroids);
      CHECK(result.residual <= 1e-3 * result.mean_cell_radius);
      CHECK(position(mesh, result.generators[0]).norm() < 1e-12);
    }
  }
}

}  // namespace gvd::test_vertex_rests
