#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "geodesic/sampling/face_distance_bound.hpp"
#include "gvd/vec.hpp"
#include "support/catch.hpp"

namespace gvd::test_face_distance_bound {

struct Triangle {
  std::array<Vec2, 3> corner;

  double side(std::size_t i) const { return (corner[(i + 1) % 3] - corner[i]).norm(); }
  double twice_area() const {
    const Vec2 b = corner[1] - corner[0], c = corner[2] - corner[0];
    return std::abs(b.x() * c.y() - b.y() * c.x());
  }
  double bound(const std::array<double, 3>& distance) const {
    return compute_face_distance_bound({{side(0), side(1), side(2)}, twice_area()}, distance);
  }
  /// The largest value on a grid of points.
  double brute_force(const std::array<double, 3>& distance, int n) const {
    double largest = 0;
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; i + k <= n; ++k) {
        const Vec2 p = (i * corner[0] + k * corner[1] + (n - i - k) * corner[2]) / n;
        double value = 1e300;
        for (std::size_t c = 0; c < 3; ++c) value = std::min(value, distance[c] + (p - corner[c]).norm());
        largest = std::max(largest, value);
      }
    }
    return largest;
  }
};

TEST_CASE("face distance bound: it bounds the distance of every point, and not by much more") {
  std::mt19937 random(1);
  const auto real = [&] { return double(random()) / double(std::mt19937::max()); };
  for (int trial = 0; trial < 2000; ++trial) {
    Triangle t{{Vec2(0, 0), Vec2(1, 0), Vec2(2 * real() - 0.5, 0.001 + (trial % 2 ? real() : 0.05 * real()))}};
    // Distances of a plane with generators round the triangle: they differ by no more than a side.
    std::array<double, 3> distance{1e300, 1e300, 1e300};
    const int generators = 1 + trial % 5;
    for (int g = 0; g < generators; ++g) {
      const double angle = 2 * std::numbers::pi * real(), far = 0.5 + 2 * real();
      const Vec2 p(far * std::cos(angle), far * std::sin(angle));
      for (std::size_t c = 0; c < 3; ++c) distance[c] = std::min(distance[c], (p - t.corner[c]).norm());
    }
    const double truth = t.brute_force(distance, 100);
    const double longest = std::max({t.side(0), t.side(1), t.side(2)});
    const double bound = t.bound(distance);
    INFO("trial " << trial);
    CHECK(bound >= truth * (1 - 1e-12));
    // The bound on a side ignores the third corner; otherwise it is exact up to the spacing of the grid.
    CHECK(bound <= truth + 0.5 * longest);
    CHECK(bound <= *std::max_element(distance.begin(), distance.end()) + longest / std::numbers::sqrt3 + 1e-12);
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 3> nearer = distance;
      nearer[c] -= 0.05 * real();
      CHECK(t.bound(nearer) <= bound * (1 + 1e-9));
    }
  }
}

TEST_CASE("face distance bound: exact at the centre of an equilateral triangle") {
  const Triangle t{{Vec2(0, 0), Vec2(1, 0), Vec2(0.5, std::sqrt(0.75))}};
  CHECK(t.bound({1, 1, 1}) == Approx(1 + 1 / std::numbers::sqrt3).epsilon(1e-12));
  CHECK(t.bound({0, 0, 0}) == Approx(1 / std::numbers::sqrt3).epsilon(1e-12));
}

TEST_CASE("face distance bound: a triangle without area") {
  const Triangle t{{Vec2(0, 0), Vec2(2, 0), Vec2(1, 0)}};
  CHECK(t.bound({0, 0, 0}) >= 0.5);
  CHECK(t.bound({0, 0, 0}) <= 2 / std::numbers::sqrt3 + 1e-12);
}

}  // namespace gvd::test_face_distance_bound
