#include <cmath>

#include "base/apex_foot.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_apex_foot {

TEST_CASE("an apex on the base's line is its own foot") {
  CHECK(apex_foot(2, 0, 2) == 0);
  CHECK(apex_foot(2, 2, 0) == 2);
  CHECK(apex_foot(2, 3, 1) == 3);
  CHECK(apex_foot(2, 1, 3) == -1);
}

TEST_CASE("the foot of an isosceles triangle is the middle of its base, however long its sides are") {
  for (const double side : {1.0, 1e3, 1e12}) CHECK(apex_foot(2, side, side) == 1);
}

TEST_CASE("the foot is where the coordinates say, by the base and by its inverse") {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double base = random.real(0.1, 3), x = random.real(-2, 5), y = random.real(0, 3);
    const double first = std::hypot(x, y), second = std::hypot(x - base, y);
    REQUIRE(apex_foot(base, first, second) == Approx(x).epsilon(1e-12).margin(1e-12));
    REQUIRE(apex_foot_by_inverse(base, 1 / base, first, second) == Approx(x).epsilon(1e-12).margin(1e-12));
  }
}

}  // namespace gvd::test_apex_foot
