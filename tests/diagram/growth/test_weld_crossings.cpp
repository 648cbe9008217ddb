#include <vector>

#include "diagram/growth/weld_crossings.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/same_crossings.hpp"

namespace gvd::test_weld_crossings {

using test::require_same_order;

const GeneratorId kA(0), kB(1), kC(2);

/// Three crossings on edge 0 and one on edge 2.
Crossings sample_crossings() {
  return Crossings(
      3, {{EdgeId(0), 0.2, kA, kB}, {EdgeId(0), 0.5, kB, kC}, {EdgeId(0), 0.8, kC, kA}, {EdgeId(2), 0.4, kA, kB}});
}

CrossingEstimate estimate(int crossing, double t) { return {CrossingId(crossing), t}; }

TEST_CASE("the weld takes the mean, and keeps a crossing without an estimate") {
  Crossings crossings = sample_crossings();
  weld_crossings({estimate(1, 0.4), estimate(3, 0.7), estimate(1, 0.46)}, crossings);
  CHECK(crossings.items()[0].t == 0.2);
  CHECK(crossings.items()[1].t == Approx(0.43));
  CHECK(crossings.items()[2].t == 0.8);
  CHECK(crossings.items()[3].t == 0.7);
}

TEST_CASE("the weld keeps the order and the least distances for any estimates") {
  Crossings crossings = sample_crossings();
  weld_crossings({estimate(0, 0.95), estimate(1, 0.01), estimate(2, 0.99999999), estimate(3, 1e-12)}, crossings);
  require_same_order(sample_crossings(), crossings);
  CHECK(crossings.items()[0].t == Approx(0.5 - kCrossingGap));
  CHECK(crossings.items()[2].t == Approx(1 - kCrossingGap));
  CHECK(crossings.items()[3].t == Approx(kCrossingGap));
  test::Random random(22);
  for (int i = 0; i < 2000; ++i) {
    Crossings fuzzed = sample_crossings();
    std::vector<CrossingEstimate> estimates;
    for (int k = random.below(9); k > 0; --k) estimates.push_back(estimate(random.below(4), random.real(0, 1)));
    weld_crossings(estimates, fuzzed);
    require_same_order(sample_crossings(), fuzzed);
  }
}

TEST_CASE("two crossings at their least distance stay") {
  const Crossings before(1, {{EdgeId(0), 0.5, kA, kB}, {EdgeId(0), 0.5 + kCrossingGap, kB, kC}});
  Crossings after = before;
  weld_crossings({estimate(0, 0.9), estimate(1, 0.1)}, after);
  CHECK(after.items()[0].t == Approx(0.5).margin(1e-12));
  CHECK(after.items()[1].t - after.items()[0].t >= kCrossingGap * (1 - 1e-6));
}

}  // namespace gvd::test_weld_crossings
