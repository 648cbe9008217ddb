#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "diagram/envelope/edge_crossings.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_edge_crossings {

EdgeSource source(double x, double depth, double offset) { return {0, 1, x, depth, offset, GeneratorId(0)}; }

/// Random sources of an edge of length 1, some of them on it or without an offset.
EdgeSource random_source(test::Random& random) {
  return source(random.real(-1, 2), random.below(4) == 0 ? 0 : random.real(0, 1),
                random.below(3) == 0 ? 0 : random.real(0, 1));
}

TEST_CASE("a source compared with itself stays open, and has no position") {
  const EdgeSource s = source(0.5, 0.2, 0.1);
  CHECK(compare_sources(s, s, 0, 1) == Nearer::open);
  for (const double t : equidistant_positions(s, s, 1)) CHECK(t == -1);
}

TEST_CASE("two sources of one image with different offsets are never decided wrongly") {
  // The roots of the squares may be inside of the edge, though the nearer source never changes.
  CHECK(compare_sources(source(0.5, 0.2, 0), source(0.5, 0.2, 0.3), 0, 1) != Nearer::second);
  CHECK(compare_sources(source(0.5, 0.2, 0.3), source(0.5, 0.2, 0), 0, 1) != Nearer::first);
  CHECK(compare_sources(source(0.5, 0.2, 0), source(0.5, 0.2, 3), 0, 1) == Nearer::first);
  CHECK(compare_sources(source(0.5, 0.2, 3), source(0.5, 0.2, 0), 0, 1) == Nearer::second);
}

TEST_CASE("a source that is farther at both ends but may dip in between stays open") {
  CHECK(compare_sources(source(0.5, 1, 0), source(0.5, 0.1, 0.8), 0, 1) == Nearer::open);
  CHECK(compare_sources(source(0.5, 1, 0), source(0.5, 0.1, 1.5), 0, 1) == Nearer::first);
}

TEST_CASE("equal offsets: the position is that of the perpendicular bisector") {
  const auto positions = equidistant_positions(source(0, 0.1, 0.7), source(1, 0.1, 0.7), 1);
  CHECK(std::count(positions.begin(), positions.end(), 0.5) == 1);
  CHECK(std::count(positions.begin(), positions.end(), -1) == 1);
}

TEST_CASE("what is decided holds at every sampled point, on any interval") {
  test::Random random(1);
  int decided = 0;
  for (int round = 0; round < 5000; ++round) {
    const EdgeSource a = random_source(random), b = random_source(random);
    const double begin = random.real(0, 0.9), end = random.real(begin, 1);
    const Nearer nearer = compare_sources(a, b, begin, end);
    if (nearer == Nearer::open) continue;
    ++decided;
    for (int k = 0; k <= 50; ++k) {
      const double t = begin + (end - begin) * k / 50;
      const double difference = b.straight(t) - a.straight(t);
      INFO("round " << round << " at " << t);
      REQUIRE((nearer == Nearer::first ? difference : -difference) >= -1e-14);
    }
  }
  CHECK(decided > 2500);
}

TEST_CASE("positions include every change of the nearer source, at any scale of the edge") {
  test::Random random(2);
  int changes = 0;
  for (int round = 0; round < 3000; ++round) {
    const double scale = std::ldexp(1.0, random.below(200) - 100);
    EdgeSource a = random_source(random), b = random_source(random);
    for (EdgeSource* s : {&a, &b}) s->x *= scale, s->depth *= scale, s->offset *= scale, s->end *= scale;
    const auto positions = equidistant_positions(a, b, 1 / scale);
    if (positions[1] != -1) REQUIRE_FALSE(positions[0] > positions[1]);
    constexpr int kSamples = 200;
    for (int k = 0; k < kSamples; ++k) {
      const double t = scale * k / kSamples, next = scale * (k + 1) / kSamples;
      const double first = b.straight(t) - a.straight(t), last = b.straight(next) - a.straight(next);
      if (std::min(std::abs(first), std::abs(last)) < 1e-9 * scale || (first < 0) == (last < 0)) continue;
      ++changes;
      INFO("round " << round << " at " << t / scale);
      REQUIRE(std::any_of(positions.begin(), positions.end(),
                          [&](double p) { return p >= t - 1e-6 * scale && p <= next + 1e-6 * scale; }));
    }
  }
  CHECK(changes > 500);
}

TEST_CASE("two images nearly in one place, far from the start of the edge, are told apart") {
  // With offsets that hardly differ the two roots nearly coincide: the discriminant keeps half of the digits. Counted
  // from the start of the edge, these do not reach down to the distance of the images.
  for (const double apart : {1e-6, 1e-9, 1e-11}) {
    const EdgeSource a = source(1 - 0.1 * apart, apart, 6e-14), b = source(1, 0, 3e-14);
    const auto positions = equidistant_positions(a, b, 1);
    INFO(apart << " apart: " << positions[0] << " and " << positions[1]);
    CHECK(std::any_of(positions.begin(), positions.end(),
                      [&](double t) { return std::abs(a.straight(t) - b.straight(t)) <= 1e-4 * apart; }));
  }
}

TEST_CASE("two images that tie at the start of the edge, but for a tiny offset, change just behind it") {
  // On a bipyramid of needles with a generator in each face. The position lies 4e-9 from the start, by the slopes
  // there.
  const EdgeSource a = source(0.89477948613550307, 0.003487944182557612, 2.1474927273429897e-13);
  const EdgeSource b = source(0.89476740056005333, 0.0058132141316566705, 1.6106195455072423e-13);
  const auto positions = equidistant_positions(a, b, 1);
  INFO(positions[0] << " and " << positions[1]);
  CHECK(positions[0] < -3e-9);
  CHECK(positions[1] > 3e-9);
  CHECK(positions[1] < 5e-9);
}

TEST_CASE("Newton's steps improve a position, and stay in the interval") {
  const EdgeSource a = source(0.1, 0.2, 0), b = source(0.8, 0.3, 0.1);
  const auto positions = equidistant_positions(a, b, 1);
  const double exact = *std::find_if(positions.begin(), positions.end(), [](double t) { return t > 0 && t < 1; });
  const double refined = refine_equidistant(a, b, 0, 1, exact + 1e-4);
  CHECK(std::abs(a.straight(refined) - b.straight(refined)) < 1e-15);
  const double bounded = refine_equidistant(a, b, exact + 1e-5, 1, exact + 1e-4);
  CHECK(bounded > exact + 1e-5);
}

struct Interval {
  double begin, end;
};

EdgeSource source(int generator, const Interval& interval, double x, double depth, double offset) {
  return {interval.begin, interval.end, x, depth, offset, GeneratorId(generator)};
}

/// Length of the straight path of the source that an envelope says is the nearest at t.
double straight_at(const EdgeEnvelope& envelope, const std::vector<EdgeSource>& sources, double t) {
  for (const EdgeEnvelope::Segment& s : envelope.segments()) {
    if (t <= s.end) return sources[s.source].straight(t);
  }
  return std::numeric_limits<double>::infinity();
}

TEST_CASE("two equal sources: the first one is the nearest everywhere") {
  EdgeEnvelope envelope;
  envelope.build({source(4, {0, 2}, 1, 1, 0), source(2, {0, 2}, 1, 1, 0)}, 2, {});
  REQUIRE(envelope.segments().size() == 1);
  CHECK(envelope.generator(envelope.segments()[0]) == GeneratorId(4));
  CHECK(envelope.segments()[0].end == 2);
}

TEST_CASE("with symbolic offsets, the lower generator wins a tie in any order of the sources") {
  for (const int first : {2, 4}) {
    EdgeEnvelope envelope;
    envelope.build({source(first, {0, 2}, 1, 1, 0), source(6 - first, {0, 2}, 1, 1, 0)}, 2, {1e-12});
    REQUIRE(envelope.segments().size() == 1);
    CHECK(envelope.generator(envelope.segments()[0]) == GeneratorId(2));
    const std::vector<EdgeSource>& kept = envelope.sources();
    const double lower = kept[0].generator < kept[1].generator ? kept[0].straight(1) : kept[1].straight(1);
    const double higher = kept[0].generator < kept[1].generator ? kept[1].straight(1) : kept[0].straight(1);
    CHECK(higher - lower == Approx(2e-12).epsilon(1e-3));
  }
}

TEST_CASE("a source with an empty interval, or one outside of the edge, has no segment") {
  EdgeEnvelope envelope;
  envelope.build({source(0, {0, 1}, 0.5, 5, 0), source(1, {0.5, 0.5}, 0.5, 0, 0), source(2, {1.2, 1.5}, 1.3, 0, 0),
                  source(3, {-1, 0}, 0, 0, 0)},
                 1, {});
  REQUIRE(envelope.segments().size() == 1);
  CHECK(envelope.generator(envelope.segments()[0]) == GeneratorId(0));
}

TEST_CASE("a source that is nearer inside its interval cuts a segment in three") {
  EdgeEnvelope envelope;
  envelope.build({source(0, {0, 1}, 0.5, 2, 0), source(1, {0.4, 0.6}, 0.5, 1, 0)}, 1, {});
  REQUIRE(envelope.segments().size() == 3);
  CHECK(envelope.segments()[0].end == 0.4);
  CHECK(envelope.segments()[1].end == 0.6);
  CHECK(envelope.segments()[2].end == 1);
  CHECK(envelope.generator(envelope.segments()[1]) == GeneratorId(1));
}

TEST_CASE("segments ascend to the edge's end, and none of the sources is nearer than theirs, at any scale") {
  test::Random random(4);
  for (int round = 0; round < 1000; ++round) {
    const double length = std::pow(10, random.real(-6, 6));
    std::vector<EdgeSource> sources{source(0, {0, length}, 0, 0, random.real(0, 1) * length),
                                    source(1, {0, length}, length, 0, random.real(0, 1) * length)};
    for (int g = random.below(8); g > 0; --g) {
      const double begin = random.real(0, length), end = random.real(begin, length);
      sources.push_back(source(g + 1, {begin, end}, random.real(-1, 2) * length, random.real(0, 1) * length,
                               random.below(2) * random.real(0, 0.5) * length));
    }
    EdgeEnvelope envelope;
    envelope.build(sources, length, {});
    double last = 0;
    for (const EdgeEnvelope::Segment& s : envelope.segments()) {
      REQUIRE(s.end > last);
      last = s.end;
    }
    REQUIRE(last == length);
    for (int k = 0; k < 60; ++k) {
      const double t = length * (k + 0.5) / 60;
      double least = std::numeric_limits<double>::infinity();
      for (const EdgeSource& s : sources) {
        if (t >= s.begin && t <= s.end) least = std::min(least, s.straight(t));
      }
      INFO("round " << round);
      REQUIRE(straight_at(envelope, sources, t) <= least + 1e-12 * length);
    }
  }
}

/// The path from an end of the edge, along it.
EdgeSource from_end(int generator, double length, double x, double distance) {
  return source(generator, {0, length}, x, 0, distance);
}

TEST_CASE("the path from an end that a window of its generator reaches has no segment") {
  const EdgeSource window = source(3, {0, 2}, 0.5, 1, 0.25);
  for (const double end : {0.0, 2.0}) {
    EdgeEnvelope envelope;
    envelope.build({from_end(3, 2, end, window.straight(end)), window}, 2, {});
    REQUIRE(envelope.segments().size() == 1);
    CHECK(envelope.segments()[0].source == 1);
  }
}

TEST_CASE("the path from an end stays where it is shorter, of another generator, or behind a jump") {
  const EdgeSource window = source(3, {0, 2}, 0.5, 1, 0.25);
  const auto first_source = [&](const std::vector<EdgeSource>& sources) {
    EdgeEnvelope envelope;
    envelope.build(sources, 2, {});
    return envelope.segments()[0].source;
  };
  CHECK(first_source({from_end(3, 2, 0, window.straight(0) - 1e-3), window}) == 0);
  CHECK(first_source({from_end(4, 2, 0, window.straight(0) - 1e-3), window}) == 0);
  // The window ends, and a farther one goes on: the path along the edge is the nearer one there.
  EdgeEnvelope envelope;
  const EdgeSource near = source(3, {0, 1}, 0.5, 1, 0.25), far = source(3, {1, 2}, 0.5, 1, 5);
  envelope.build({from_end(3, 2, 0, near.straight(0)), near, far}, 2, {});
  CHECK(envelope.segments().back().source == 0);
}

TEST_CASE("the paths from the ends fill what no window reaches") {
  EdgeEnvelope envelope;
  envelope.build({from_end(0, 1, 0, 1), from_end(1, 1, 1, 1), source(2, {0.4, 0.6}, 0.5, 0.1, 0)}, 1, {});
  REQUIRE(envelope.segments().size() == 3);
  CHECK(envelope.segments()[0].source == 0);
  CHECK(envelope.segments()[1].source == 2);
  CHECK(envelope.segments()[2].source == 1);
}

TEST_CASE("segments ascend where windows are as narrow as rounding, and reach the end of the edge") {
  test::Random random(5);
  for (int round = 0; round < 2000; ++round) {
    std::vector<EdgeSource> sources{from_end(0, 1, 0, 1), from_end(1, 1, 1, 1)};
    double begin = random.below(2) * random.real(0, 0.5);
    for (int k = 0; k < 6; ++k) {
      const double end = std::min(1.0, begin + random.real(0, 3e-11) + random.below(2) * random.real(0, 0.3));
      sources.push_back(source(k % 2, {begin, end}, random.real(0, 1), random.real(0.1, 1), random.real(0, 0.3)));
      begin = end + random.real(-1e-11, 1e-11);
    }
    EdgeEnvelope envelope;
    envelope.build(sources, 1, {});
    double last = 0;
    for (const EdgeEnvelope::Segment& s : envelope.segments()) {
      REQUIRE(s.source >= 0);
      REQUIRE(s.end > last);
      last = s.end;
    }
    REQUIRE(last == 1);
  }
}

TEST_CASE("windows that meet but for rounding leave no segment between them") {
  for (const double gap : {-1e-15, 0.0, 1e-15}) {
    EdgeEnvelope envelope;
    envelope.build({from_end(0, 1, 0, 9), from_end(0, 1, 1, 9), source(0, {0, 0.5}, 0.5, 1, 0),
                    source(0, {0.5 + gap, 1}, 0.5, 1, 0), source(1, {0, 1}, 0.5, 1, 3)},
                   1, {});
    INFO("gap " << gap);
    REQUIRE(envelope.segments().size() == 2);
    CHECK(envelope.segments()[0].end == Approx(0.5));
    CHECK(envelope.generator(envelope.segments()[1]) == GeneratorId(0));
  }
}

TEST_CASE("a generator without a source is infinitely far along an edge") {
  EdgeDistances distances;
  distances.build({{0, 1, 0, 0, 0, GeneratorId(0)}, {0, 1, 1, 0, 0, GeneratorId(2)}});
  CHECK(std::isinf(distances.at(GeneratorId(1), 0.5)));
  CHECK(std::isinf(distances.at(GeneratorId(3), 0.5)));
  CHECK(distances.at(GeneratorId(0), 0.25) == 0.25);
  CHECK(distances.at(GeneratorId(2), 0.25) == 0.75);
}

TEST_CASE("the distances along an edge are the least over the sources of a generator, in any order") {
  test::Random random(11);
  for (int round = 0; round < 500; ++round) {
    std::vector<EdgeSource> sources;
    for (int k = random.below(30); k >= 0; --k) {
      const double begin = random.real(0, 1), end = random.real(begin, 1);
      const double offset = random.below(2) * random.real(0, 0.5);
      sources.push_back({begin, end, random.real(-1, 2), random.real(0, 1), offset, GeneratorId(random.below(4))});
    }
    EdgeDistances distances;
    distances.build(sources);
    for (int g = 0; g < 4; ++g) {
      const double t = random.real(0, 1);
      double least = std::numeric_limits<double>::infinity();
      for (const EdgeSource& s : sources) {
        if (s.generator == GeneratorId(g)) least = std::min(least, s.distance(t));
      }
      INFO("round " << round);
      if (std::isinf(least)) {
        REQUIRE(std::isinf(distances.at(GeneratorId(g), t)));
      } else {
        REQUIRE(distances.at(GeneratorId(g), t) == Approx(least).epsilon(1e-15));
      }
    }
  }
}

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
