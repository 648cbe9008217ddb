#include <algorithm>
#include <cmath>

#include "diagram/envelope/compare_sources.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_compare_sources {

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

}  // namespace gvd::test_compare_sources
