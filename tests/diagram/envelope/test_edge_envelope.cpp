#include <algorithm>
#include <cmath>
#include <limits>

#include "diagram/envelope/edge_envelope.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_edge_envelope {

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

}  // namespace gvd::test_edge_envelope
