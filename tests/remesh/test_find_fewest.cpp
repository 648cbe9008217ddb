#include <cmath>
#include <limits>

#include "gvd/error.hpp"
#include "gvd/find_fewest.hpp"
#include "support/catch.hpp"

namespace gvd::test_find_fewest {

TEST_CASE("fewest: the number is found within the tolerance, in few trials") {
  for (const double power : {0.5, 1.0, 1.5}) {
    for (const double target : {1e-4, 1e-2, 0.3, 5.0}) {
      FewestOptions options;
      options.target = target;
      const double exact = std::ceil(std::pow(10 / target, 1 / power));
      if (exact > options.most) continue;
      const Fewest found = find_fewest(options, [&](std::int32_t n) { return 10 / std::pow(n, power); });
      INFO(power << ", " << target);
      REQUIRE(found.count);
      CHECK(*found.count >= exact);
      CHECK(*found.count <= std::max(exact + 1, 1.02 * exact));
      CHECK(found.trials.size() <= 16);
    }
  }
}

TEST_CASE("fewest: the result is the smallest of those tried that are enough, though errors do not fall evenly") {
  FewestOptions options;
  options.target = 0.01;
  const auto error = [](std::int32_t n) { return (10 + 3 * std::sin(n)) / n; };
  const Fewest found = find_fewest(options, error);
  REQUIRE(found.count);
  for (const CountTrial& trial : found.trials) {
    CHECK(trial.error == error(trial.count));
    if (trial.error <= options.target) CHECK(trial.count >= *found.count);
  }
}

TEST_CASE("fewest: no number where the largest is too small, one where all are enough") {
  FewestOptions options;
  options.target = 1;
  options.most = 500;
  const Fewest none = find_fewest(options, [](std::int32_t) { return std::numeric_limits<double>::infinity(); });
  CHECK_FALSE(none.count);
  CHECK(none.trials.back().count == 500);
  CHECK(find_fewest(options, [](std::int32_t) { return 0.5; }).count == 1);
  options.tolerance = -0.1;
  CHECK_THROWS_AS(find_fewest(options, [](std::int32_t) { return 0.5; }), Error);
  options.tolerance = 0;
  options.first = 501;
  CHECK_THROWS_AS(find_fewest(options, [](std::int32_t) { return 0.5; }), Error);
}

}  // namespace gvd::test_find_fewest
