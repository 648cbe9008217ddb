// Signs of orientations where rounding leaves them open.
#include <cmath>

#include "intersection/exact_orientation.hpp"
#include "support/catch.hpp"

namespace gvd::test_exact_orientation {

/// x + units in its last place.
double nudged(double x, int units) {
  for (; units > 0; --units) x = std::nextafter(x, 1e300);
  for (; units < 0; ++units) x = std::nextafter(x, -1e300);
  return x;
}

TEST_CASE("points one unit in the last place beside a line are on its sides") {
  const Vec2 a(12, 12), b(24, 24);
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      const Vec2 c(nudged(0.5, x), nudged(0.5, y));
      CHECK(exact_orientation(a, b, c) == (c.y() > c.x()) - (c.y() < c.x()));
    }
  }
}

TEST_CASE("points one unit in the last place beside a plane are on its sides") {
  // The plane x = y + z holds the first three points. All their coordinates are exact.
  const Vec3 a(0, 0, 0), b(24, 12, 12), c(17, 9, 8);
  CHECK(exact_orientation(a, b, c, Vec3(0.75, 0.5, 0.25)) == 0);
  for (int units = -3; units <= 3; ++units) {
    const Vec3 d(nudged(0.75, units), 0.5, 0.25);
    const int side = exact_orientation(a, b, c, d);
    CHECK(side == exact_orientation(a, b, c, Vec3(1, 0, 0)) * ((units > 0) - (units < 0)));
    CHECK(exact_orientation(b, a, c, d) == -side);
    CHECK(exact_orientation(d, b, c, a) == -side);
  }
}

TEST_CASE("a, b and c appear counter-clockwise from the positive side") {
  CHECK(exact_orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)) == 1);
  CHECK(exact_orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)) == -1);
  CHECK(exact_orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, -1)) == 0);
}

}  // namespace gvd::test_exact_orientation
