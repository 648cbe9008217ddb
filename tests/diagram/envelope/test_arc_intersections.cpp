#include <algorithm>
#include <cmath>

#include "diagram/envelope/arc_intersections.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace gvd;

namespace {

using Pairs = std::vector<ArcIntersections::Pair>;

/// The segments of polylines, one arc each.
std::vector<ArcSegment> segments_of(const std::vector<std::vector<Vec2>>& arcs) {
  std::vector<ArcSegment> segments;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (std::size_t k = 1; k < arcs[i].size(); ++k)
      segments.push_back({{arcs[i][k - 1], arcs[i][k]}, static_cast<std::int32_t>(i)});
  }
  return segments;
}

Pairs meetings_of(const std::vector<std::vector<Vec2>>& arcs) {
  ArcIntersections meetings;
  return meetings.find(segments_of(arcs));
}

}  // namespace

TEST_CASE("no arc, one segment, and two that follow each other meet nowhere") {
  CHECK(meetings_of({}).empty());
  CHECK(meetings_of({{{0, 0}, {1, 1}}}).empty());
  CHECK(meetings_of({{{0, 0}, {1, 1}, {0.5, 0.2}}}).empty());
}

TEST_CASE("arcs that cross meet, with themselves too; those that end in one point don't") {
  CHECK(meetings_of({{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}}) == Pairs{{0, 1}});
  CHECK(meetings_of({{{0, 0}, {1, 1}}, {{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}}).empty());
  CHECK(meetings_of({{{0, 0}, {1, 0}, {1, 1}, {0.5, -1}}}) == Pairs{{0, 0}});
}

TEST_CASE("an arc that ends on another one, or runs along a part of it, meets it") {
  CHECK(meetings_of({{{0, 0}, {1, 0}}, {{0.3, 0}, {0.5, 1}}}) == Pairs{{0, 1}});
  CHECK(meetings_of({{{0, 0}, {1, 0}}, {{0.3, 0}, {0.6, 0}}}) == Pairs{{0, 1}});
  CHECK(meetings_of({{{0, 0}, {1, 0}}, {{1.5, 0}, {2, 0}}}).empty());
}

TEST_CASE("what rounding leaves open counts as met, what is beyond it does not") {
  const double third = 1.0 / 3;
  const auto touching = [&](double above) {
    return meetings_of({{{0, 0}, {1, third}}, {{0.3, 0.3 * third + above}, {0.2, 1}}});
  };
  CHECK(touching(1e-17) == Pairs{{0, 1}});
  CHECK(touching(1e-15).empty());
}

TEST_CASE("as every pair of segments by itself, for random arcs of many lengths and sizes") {
  test::Random random(3);
  ArcIntersections meetings;
  for (int round = 0; round < 400; ++round) {
    std::vector<std::vector<Vec2>> arcs(static_cast<std::size_t>(1 + random.below(5)));
    for (auto& arc : arcs) {
      const double size = std::pow(10, random.real(-6, 0));
      Vec2 p(random.real(0, 1), random.real(0, 1));
      for (int k = random.below(30); k >= 0; --k, p += size * Vec2(random.real(-1, 1), random.real(-1, 1)))
        arc.push_back(p);
    }
    const auto segments = segments_of(arcs);
    Pairs expected;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (may_intersect(segments[i].line, segments[j].line))
          expected.push_back(std::minmax({segments[i].arc, segments[j].arc}));
      }
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    INFO("round " << round);
    REQUIRE(meetings.find(segments) == expected);
  }
}
