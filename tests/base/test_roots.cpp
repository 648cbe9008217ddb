#include <algorithm>
#include <cmath>
#include <utility>

#include "base/roots.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_roots {

constexpr double kWidth = 1e-14;

/// The root, and the number of evaluations that it took.
template <class Function>
std::pair<double, int> count_root(double begin, double end, const Function& function) {
  int count = 0;
  const double root = find_root({begin, end, function(begin), function(end)}, kWidth, [&](double x) {
    ++count;
    return function(x);
  });
  return {root, count};
}

TEST_CASE("the root of a line is found by one secant, exactly") {
  const auto [root, count] = count_root(-1, 3, [](double x) { return 2 * x - 1; });
  CHECK(root == 0.5);
  CHECK(count == 1);
}

TEST_CASE("the root of a smooth function is found within the width") {
  const auto [root, count] = count_root(0, 2, [](double x) { return x * x - 2; });
  CHECK(std::abs(root - std::sqrt(2)) <= kWidth);
  CHECK(count < 40);
}

TEST_CASE("where the secant stagnates, halving goes on") {
  // The secant's end at 1 would never move: the function is flat up to there.
  const auto [root, count] = count_root(0, 1, [](double x) { return std::pow(x, 20) - 1e-10; });
  CHECK(root == Approx(std::pow(1e-10, 0.05)).epsilon(1e-12));
  CHECK(count <= 100);
}

TEST_CASE("a jump from negative to positive is found as well") {
  const auto [root, count] = count_root(0, 1, [](double x) { return x < 0.7 ? -1.0 : 1.0; });
  CHECK(root == Approx(0.7).epsilon(1e-13));
  CHECK(count <= 100);
}

TEST_CASE("a bracket that is narrow enough is not evaluated") {
  int count = 0;
  const double root = find_root({1, 1 + 1e-15, -1, 1}, kWidth, [&](double) { return ++count; });
  CHECK(count == 0);
  CHECK(root >= 1);
  CHECK(root <= 1 + 1e-15);
}

TEST_CASE("a function without a number ends the search inside of the bracket") {
  const double root = find_root({0, 1, -1, 1}, kWidth, [](double) { return std::nan(""); });
  CHECK(root >= 0);
  CHECK(root <= 1);
}

TEST_CASE("find_last halves down to the last accepted number, and never returns a refused one") {
  for (const double limit : {0.0, 1e-9, 0.25, 1.0 / 3, 0.999}) {
    const double last = find_last(45, [&](double t) { return t <= limit; });
    CHECK(last <= limit);
    CHECK(last >= limit - std::ldexp(1.0, -45));
  }
  CHECK(find_last(45, [](double) { return false; }) == 0);
  CHECK(find_last(3, [](double) { return true; }) == 0.875);
}

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

}  // namespace gvd::test_roots
