#include <cmath>
#include <limits>
#include <vector>

#include "diagram/envelope/edge_crossings.hpp"
#include "diagram/envelope/edge_envelope.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_edge_crossings {

const GeneratorId kA(0), kB(1), kC(2);

/// Straight paths to all of an edge of length 1.
EdgeSource all_over(GeneratorId g, double x, double depth, double offset) { return {0, 1, x, depth, offset, g}; }

/// The nearest generator at t by looking at every source.
GeneratorId nearest_at(const std::vector<EdgeSource>& sources, double t) {
  const EdgeSource* best = &sources.front();
  for (const EdgeSource& s : sources) {
    if (s.distance(t) < best->distance(t)) best = &s;
  }
  return best->generator;
}

double distance_at(const std::vector<EdgeSource>& sources, GeneratorId g, double t) {
  double least = std::numeric_limits<double>::infinity();
  for (const EdgeSource& s : sources) {
    if (s.generator == g) least = std::min(least, s.distance(t));
  }
  return least;
}

/// Puts the sources of the edge's two ends in front, as far as their nearest generator is.
std::vector<EdgeSource> with_ends(std::vector<EdgeSource> sources) {
  const GeneratorId first = nearest_at(sources, 0), last = nearest_at(sources, 1);
  const EdgeSource start{0, 1, 0, 0, distance_at(sources, first, 0), first};
  const EdgeSource end{0, 1, 1, 0, distance_at(sources, last, 1), last};
  sources.insert(sources.begin(), {start, end});
  return sources;
}

std::vector<Crossing> find_crossings(const std::vector<EdgeSource>& sources, GeneratorId first, GeneratorId last,
                                     double offset_step = 0) {
  EdgeEnvelope envelope;
  envelope.build(sources, 1, {offset_step});
  std::vector<Crossing> crossings;
  EdgeCrossings().append_all(envelope, EdgeId(7), first, last, crossings);
  return crossings;
}

std::vector<Crossing> find_crossings(const std::vector<EdgeSource>& sources) {
  return find_crossings(sources, sources[0].generator, sources[1].generator);
}

/// The properties of Crossings, along one edge.
void require_chain(const std::vector<Crossing>& crossings, GeneratorId first, GeneratorId last) {
  GeneratorId here = first;
  double before = 0;
  for (const Crossing& c : crossings) {
    REQUIRE(c.edge == EdgeId(7));
    REQUIRE(c.before == here);
    REQUIRE(c.after != here);
    REQUIRE(c.t > before);
    REQUIRE(c.t < 1);
    here = c.after;
    before = c.t;
  }
  REQUIRE(here == last);
}

GeneratorId label_at(const std::vector<Crossing>& crossings, GeneratorId first, double t) {
  GeneratorId label = first;
  for (const Crossing& c : crossings) {
    if (c.t < t) label = c.after;
  }
  return label;
}

TEST_CASE("two images without offsets have a crossing on their perpendicular bisector") {
  // On the perpendicular bisector of (0.1, -0.2) and (0.8, -0.3).
  const auto crossings = find_crossings(with_ends({all_over(kA, 0.1, 0.2, 0), all_over(kB, 0.8, 0.3, 0)}));
  REQUIRE(crossings.size() == 1);
  CHECK(crossings[0].t == Approx((0.64 + 0.09 - 0.01 - 0.04) / (2 * 0.7)).epsilon(1e-14));
}

TEST_CASE("two images with the same offset have the crossing that they have without") {
  const auto crossings = find_crossings(with_ends({all_over(kA, 0.1, 0.2, 0.7), all_over(kB, 0.8, 0.3, 0.7)}));
  REQUIRE(crossings.size() == 1);
  CHECK(crossings[0].t == Approx(0.68 / 1.4).epsilon(1e-14));
}

TEST_CASE("two images with different offsets are equally far from their crossing") {
  for (const double offset : {1e-12, 1e-6, 0.1, 0.4}) {
    const auto sources = with_ends({all_over(kA, 0.1, 0.2, 0), all_over(kB, 0.8, 0.3, offset)});
    const auto crossings = find_crossings(sources);
    REQUIRE(crossings.size() == 1);
    const double t = crossings[0].t;
    CHECK(sources[2].straight(t) == Approx(sources[3].straight(t)).epsilon(2e-14));
  }
}

TEST_CASE("a cell that intersects an edge between two labels of another cell makes two crossings") {
  const auto sources = with_ends({all_over(kA, 0.5, 1, 0), all_over(kB, 0.5, 0.1, 0.8)});
  const auto crossings = find_crossings(sources);
  REQUIRE(crossings.size() == 2);
  require_chain(crossings, kA, kA);
  CHECK(crossings[0].after == kB);
  CHECK(crossings[0].t == Approx(1 - crossings[1].t).epsilon(1e-13));
  for (const Crossing& c : crossings)
    CHECK(sources[2].straight(c.t) == Approx(sources[3].straight(c.t)).epsilon(2e-14));
}

TEST_CASE("a source that is farther everywhere makes no crossing") {
  CHECK(find_crossings(with_ends({all_over(kA, 0.5, 1, 0), all_over(kB, 0.5, 0.1, 0.95)})).empty());
}

TEST_CASE("a tie along the edge goes to the lower generator, in any order of the sources") {
  const EdgeSource a = all_over(kA, 0.5, 0.5, 0), b = all_over(kB, 0.5, 0.5, 0);
  const double end = a.straight(0);
  const EdgeSource start_cone{0, 1, 0, 0, end, kA}, end_cone{0, 1, 1, 0, end, kA};
  CHECK(find_crossings({start_cone, end_cone, a, b}, kA, kA, 1e-13).empty());
  CHECK(find_crossings({start_cone, end_cone, b, a}, kA, kA, 1e-13).empty());
}

TEST_CASE("the labels of the ends are kept where the sources contradict them") {
  const EdgeSource a = all_over(kA, 0.2, 0.5, 0), b = all_over(kB, 0.7, 0.5, 1);  // a is nearer everywhere
  const EdgeSource start{0, 1, 0, 0, a.straight(0), kA}, end{0, 1, 1, 0, a.straight(1), kA};
  for (const GeneratorId first : {kA, kB}) {
    for (const GeneratorId last : {kA, kB}) {
      const auto crossings = find_crossings({start, end, a, b}, first, last);
      require_chain(crossings, first, last);
      CHECK(crossings.size() == std::size_t(first == kB) + std::size_t(last == kB));
    }
  }
}

TEST_CASE("a gap by rounding between two windows of one generator makes no crossing") {
  // In the gap only the cones of the ends are left of A, and B is nearer than those.
  for (const double gap : {1e-12, 1e-9, 4e-7, 3e-6, 1e-3}) {
    EdgeSource left = all_over(kA, 0.5, 0.5, 0), right = left;
    left.end = 0.5 - 0.5 * gap;
    right.begin = 0.5 + 0.5 * gap;
    const auto sources = with_ends({left, right, all_over(kB, 0.5, 0.6, 0.2)});
    CHECK(find_crossings(sources).empty());
  }
}

TEST_CASE("in a wide gap between two windows another cell makes two crossings") {
  EdgeSource left = all_over(kA, 0.5, 0.5, 0), right = left;
  left.end = 0.2;
  right.begin = 0.8;
  const auto crossings = find_crossings(with_ends({left, right, all_over(kB, 0.5, 0.1, 0.45)}));
  require_chain(crossings, kA, kA);
  CHECK(crossings.size() == 2);
}

TEST_CASE("a label interval as short as rounding is dropped, a longer one stays") {
  for (const auto& [width, expected] : {std::pair(5e-12, 0), std::pair(2e-11, 2), std::pair(1e-7, 2)}) {
    EdgeSource dip = all_over(kB, 0.5, 0.1, 0.8);
    dip.begin = 0.5;
    dip.end = 0.5 + width;
    CHECK(find_crossings(with_ends({all_over(kA, 0.5, 1, 0), dip})).size() == std::size_t(expected));
  }
}

TEST_CASE("a single crossing is equally far from the labels of the ends, whichever generator is nearest there") {
  const auto sources = with_ends({all_over(kA, 0, 0.1, 0), all_over(kB, 1, 0.2, 0), all_over(kC, 0.5, 0.01, 0)});
  EdgeEnvelope envelope;
  envelope.build(sources, 1, {});
  std::vector<Crossing> crossings;
  EdgeCrossings().append_all(envelope, EdgeId(7), kA, kB, crossings);
  CHECK(crossings.size() == 2);
  crossings.clear();
  EdgeCrossings().append_single(envelope, EdgeId(7), kA, kB, crossings);
  require_chain(crossings, kA, kB);
  REQUIRE(crossings.size() == 1);
  CHECK(crossings[0].t == Approx(0.5 + 0.015).epsilon(1e-12));  // (1 + 0.04 - 0.01) / 2
}

TEST_CASE("random sources: the crossings agree with samples of all distances") {
  constexpr int kRounds = 400, kSamples = 400;
  test::Random random(3);
  int found = 0;
  for (int round = 0; round < kRounds; ++round) {
    INFO("round " << round);
    std::vector<EdgeSource> windows;
    const int count = 2 + random.below(5);
    for (int g = 0; g < count; ++g) {
      const double depth = std::pow(10, random.real(-3, 0)), offset = random.below(3) == 0 ? 0 : random.real(0, 0.6);
      EdgeSource whole = all_over(GeneratorId(g), random.real(-0.5, 1.5), depth, offset);
      // Cut in two, with a gap or an overlap of rounding.
      EdgeSource left = whole, right = whole;
      left.end = random.real(0.01, 0.99);
      right.begin = left.end + random.real(-1e-10, 1e-10);
      windows.push_back(left);
      windows.push_back(right);
    }
    const auto sources = with_ends(windows);
    const auto crossings = find_crossings(sources);
    require_chain(crossings, sources[0].generator, sources[1].generator);
    found += static_cast<int>(crossings.size());
    for (const Crossing& c : crossings) {
      const double before = distance_at(sources, c.before, c.t), after = distance_at(sources, c.after, c.t);
      REQUIRE(before == Approx(after).epsilon(1e-13));
      REQUIRE(before <= distance_at(sources, nearest_at(sources, c.t), c.t) + 1e-8);
    }
    for (int i = 0; i < kSamples; ++i) {
      const double t = (i + 0.5) / kSamples;
      const GeneratorId label = label_at(crossings, sources[0].generator, t);
      REQUIRE(distance_at(sources, label, t) <= distance_at(sources, nearest_at(sources, t), t) + 1e-8);
    }
  }
  CHECK(found > kRounds / 2);
}

}  // namespace gvd::test_edge_crossings
