// Slopes of the energy at a vertex, from the angles of the paths that leave it.
#include <cmath>
#include <numbers>
#include <random>

#include "integrals/vertex_slope.hpp"
#include "support/catch.hpp"

namespace gvd::test_vertex_slope {

using std::numbers::pi;

std::vector<VertexPath> random_paths(double total, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<VertexPath> paths;
  for (int i = 0; i < 200; ++i) {
    const double at = share(random);
    paths.push_back({total * at * at, share(random)});
  }
  return paths;
}

/// The sum of the definition, path by path.
double slope_by_definition(double total, bool is_closed, const std::vector<VertexPath>& paths, double direction) {
  double sum = 0;
  for (const VertexPath& path : paths) {
    double between = std::abs(path.angle - direction);
    if (is_closed) between = std::min(between, total - between);
    sum += -2 * path.weight * std::cos(std::min(between, pi));
  }
  return sum;
}

TEST_CASE("vertex slope: every direction has the sum over all paths, on cones, planes, saddles and boundaries") {
  for (const double total : {0.5, 2.0, pi, 5.0, 2 * pi, 7.0, 3 * pi, 16.0}) {
    for (const bool is_closed : {true, false}) {
      const std::vector<VertexPath> paths = random_paths(total, 1);
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
  std::vector<VertexPath> all_round;
  for (int i = 0; i < 90; ++i) all_round.push_back({3 * pi * i / 90, 1});
  CHECK(VertexSlope(3 * pi, true, all_round).least().slope > 0);
  CHECK(VertexSlope(2 * pi, true, {}).least().slope == 0);
}

}  // namespace gvd::test_vertex_slope
