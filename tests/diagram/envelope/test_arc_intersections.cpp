#include <algorithm>
#include <cmath>

#include "diagram/envelope/arc_intersections.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_arc_intersections {

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

Pairs intersections_of(const std::vector<std::vector<Vec2>>& arcs) {
  ArcIntersections intersections;
  return intersections.find(segments_of(arcs));
}

TEST_CASE("no arc, one segment and two consecutive segments have no intersection") {
  CHECK(intersections_of({}).empty());
  CHECK(intersections_of({{{0, 0}, {1, 1}}}).empty());
  CHECK(intersections_of({{{0, 0}, {1, 1}, {0.5, 0.2}}}).empty());
}

TEST_CASE("arcs that cross intersect, also one with itself; arcs with a common end do not") {
  CHECK(intersections_of({{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}}) == Pairs{{0, 1}});
  CHECK(intersections_of({{{0, 0}, {1, 1}}, {{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}}).empty());
  CHECK(intersections_of({{{0, 0}, {1, 0}, {1, 1}, {0.5, -1}}}) == Pairs{{0, 0}});
}

TEST_CASE("an arc that ends on another one, or overlaps it, intersects it") {
  CHECK(intersections_of({{{0, 0}, {1, 0}}, {{0.3, 0}, {0.5, 1}}}) == Pairs{{0, 1}});
  CHECK(intersections_of({{{0, 0}, {1, 0}}, {{0.3, 0}, {0.6, 0}}}) == Pairs{{0, 1}});
  CHECK(intersections_of({{{0, 0}, {1, 0}}, {{1.5, 0}, {2, 0}}}).empty());
}

TEST_CASE("an intersection that rounding leaves open is found; one beyond rounding is not") {
  const double third = 1.0 / 3;
  const auto touching = [&](double above) {
    return intersections_of({{{0, 0}, {1, third}}, {{0.3, 0.3 * third + above}, {0.2, 1}}});
  };
  CHECK(touching(1e-17) == Pairs{{0, 1}});
  CHECK(touching(1e-15).empty());
}

TEST_CASE("random arcs of many lengths and sizes: the result is that of all pairs of segments") {
  test::Random random(3);
  ArcIntersections intersections;
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
    REQUIRE(intersections.find(segments) == expected);
  }
}

}  // namespace gvd::test_arc_intersections
