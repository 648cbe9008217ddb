#include <algorithm>
#include <cmath>

#include "base/quadratic.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_quadratic {

std::array<double, 2> sorted(std::array<double, 2> roots) {
  std::sort(roots.begin(), roots.end());
  return roots;
}

TEST_CASE("degenerate quadratics: missing roots are not finite, double roots come twice") {
  const auto linear = quadratic_roots(0, 1, -3);  // 2 x - 3 = 0
  CHECK(std::count_if(linear.begin(), linear.end(), [](double x) { return std::isfinite(x); }) == 1);
  CHECK(*std::find_if(linear.begin(), linear.end(), [](double x) { return std::isfinite(x); }) == 1.5);
  for (const double x : quadratic_roots(0, 0, 1)) CHECK_FALSE(std::isfinite(x));
  CHECK(quadratic_roots(1, -2, 4) == std::array<double, 2>{2, 2});
  CHECK(sorted(quadratic_roots(1, -1, 0)) == std::array<double, 2>{0, 2});
}

TEST_CASE("a discriminant that rounding made negative counts as 0") {
  const auto roots = quadratic_roots(1, -2, 4 + 1e-15);
  CHECK(roots[0] == Approx(2).epsilon(1e-14));
  CHECK(roots[1] == Approx(2).epsilon(1e-14));
}

TEST_CASE("a small root beside a large one keeps its digits") {
  // x^2 - (1e9 + 1e-9) x + 1 = 0
  const auto roots = sorted(quadratic_roots(1, -0.5 * (1e9 + 1e-9), 1));
  CHECK(roots[0] == Approx(1e-9).epsilon(1e-15));
  CHECK(roots[1] == Approx(1e9).epsilon(1e-15));
}

TEST_CASE("the roots that a quadratic was made from come back") {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double first = random.real(-3, 3), second = random.real(-3, 3), a = random.real(0.1, 2);
    if (std::abs(first - second) < 1e-3) continue;
    const auto roots = sorted(quadratic_roots(a, -0.5 * a * (first + second), a * first * second));
    REQUIRE(roots[0] == Approx(std::min(first, second)).epsilon(1e-10).margin(1e-12));
    REQUIRE(roots[1] == Approx(std::max(first, second)).epsilon(1e-10).margin(1e-12));
  }
}

}  // namespace gvd::test_quadratic
