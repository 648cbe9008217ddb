#include <array>
#include <cmath>
#include <vector>

#include "base/plane.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_plane {

/// Exact sign of an orientation of integer points.
int exact_orientation(const std::array<long long, 6>& p) {
  const long long area = (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
  return (area > 0) - (area < 0);
}

TEST_CASE("cross and turned_left are counter-clockwise positive") {
  CHECK(cross({1, 0}, {0, 1}) == 1);
  CHECK(cross({0, 1}, {1, 0}) == -1);
  CHECK(cross({2, 3}, {4, 6}) == 0);
  CHECK(turned_left({1, 0}) == Vec2(0, 1));
  CHECK(turned_left({3, 4}) == Vec2(-4, 3));
}

TEST_CASE("unit_vector counts angles counter-clockwise from the x axis") {
  CHECK(unit_vector(0) == Vec2(1, 0));
  CHECK((unit_vector(std::acos(-1.0) / 2) - Vec2(0, 1)).norm() < 1e-15);
}

TEST_CASE("twice_signed_area changes its sign with the direction and keeps it under rotation of the corners") {
  const Vec2 a(0, 0), b(3, 0), c(1, 2);
  CHECK(twice_signed_area(a, b, c) == 6);
  CHECK(twice_signed_area(b, c, a) == 6);
  CHECK(twice_signed_area(a, c, b) == -6);
  CHECK(twice_signed_area(a, b, Vec2(7, 0)) == 0);
}

TEST_CASE("twice_signed_area of a polygon: concave, clockwise, and of fewer than three corners") {
  const auto area_of = [](const std::vector<Vec2>& polygon) {
    return twice_signed_area(polygon.size(), [&](std::size_t i) { return polygon[i]; });
  };
  CHECK(area_of({}) == 0);
  CHECK(area_of({{1, 2}}) == 0);
  CHECK(area_of({{1, 2}, {3, 5}}) == 0);
  CHECK(area_of({{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}) == 6);
  CHECK(area_of({{0, 2}, {1, 1}, {2, 2}, {2, 0}, {0, 0}}) == -6);
}

TEST_CASE("orientation: left, right, and open on the line") {
  CHECK(orientation({0, 0}, {1, 0}, {0.5, 1e-300}) == 1);
  CHECK(orientation({0, 0}, {1, 0}, {0.5, -1e-300}) == -1);
  CHECK(orientation({0, 0}, {1, 0}, {2, 0}) == 0);
  CHECK(orientation({1, 1}, {1, 1}, {2, 0}) == 0);
}

TEST_CASE("orientation: rounding never gives the wrong sign, and leaves only near ties open") {
  test::Random random(11);
  int open = 0;
  for (int round = 0; round < 20000; ++round) {
    // Three integer points near a line: their products exceed the 53 bits of a double and fit into 64.
    std::array<long long, 6> p{};
    std::array<Vec2, 3> point;
    const long long dx = random.below(1 << 20), dy = random.below(1 << 20);
    for (std::size_t i = 0; i < 3; ++i) {
      const long long along = random.below(900);
      p[2 * i] = along * dx + random.below(2);
      p[2 * i + 1] = along * dy + random.below(2);
      point[i] = Vec2(static_cast<double>(p[2 * i]), static_cast<double>(p[2 * i + 1]));
    }
    const int side = orientation(point[0], point[1], point[2]), expected = exact_orientation(p);
    INFO("round " << round);
    REQUIRE((side == 0 || side == expected));
    REQUIRE(orientation(point[1], point[0], point[2]) * expected <= 0);
    if (side == 0 && expected != 0) ++open;
  }
  CHECK(open < 200);
}

}  // namespace gvd::test_plane
