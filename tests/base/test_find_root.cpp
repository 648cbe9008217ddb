#include <cmath>
#include <utility>

#include "base/find_root.hpp"
#include "support/catch.hpp"

namespace gvd::test_find_root {

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

}  // namespace gvd::test_find_root
