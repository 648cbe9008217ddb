#include <algorithm>

#include "diagram/assembly/split_polygon.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"
#include "support/random.hpp"

namespace gvd::test_split_polygon {

/// A polygon of n corners, of which these intervals are united.
struct Split {
  std::vector<BoundaryCrossing> boundary;
  test::PointDistances distances;
  std::vector<std::vector<int>> polygons;  // the intervals of each

  Split(int n, const std::vector<std::pair<int, int>>& united) {
    std::vector<std::pair<double, int>> positions;
    for (int i = 0; i < n; ++i) positions.emplace_back(3.0 * i / n, i);
    boundary = test::boundary_of(positions);
    LabelIntervals intervals(boundary, distances);
    for (const auto& [i, j] : united) intervals.unite(i, j);
    for (const FacePolygon& polygon : split_at_united_intervals(test::polygon_of(boundary), intervals)) {
      auto& own = polygons.emplace_back();
      for (const PolygonCorner& corner : polygon) own.push_back(corner.interval);
    }
  }
};

using Polygons = std::vector<std::vector<int>>;

TEST_CASE("without united intervals there is nothing to split") {
  CHECK(Split(3, {}).polygons.empty());
  CHECK(Split(6, {}).polygons.empty());
}

TEST_CASE("neighbours, also over the last corner, do not split") {
  CHECK(Split(5, {{1, 2}}).polygons.empty());
  CHECK(Split(5, {{4, 0}}).polygons.empty());
}

TEST_CASE("two united intervals split the polygon in two, each with one of them") {
  CHECK(Split(6, {{1, 4}}).polygons == Polygons{{2, 3, 4}, {0, 1, 5}});
  CHECK(Split(4, {{0, 2}}).polygons == Polygons{{1, 2}, {0, 3}});
}

TEST_CASE("three intervals of one piece split off two polygons, nested pieces the inner one first") {
  CHECK(Split(6, {{0, 2}, {2, 4}}).polygons == Polygons{{1, 2}, {3, 4}, {0, 5}});
  CHECK(Split(8, {{0, 6}, {2, 4}}).polygons == Polygons{{3, 4}, {1, 2, 5, 6}, {0, 7}});
}

TEST_CASE("random nested pieces: every interval is in one polygon, and every polygon has two corners or more") {
  test::Random random(7);
  for (int round = 0; round < 500; ++round) {
    const int n = 4 + random.below(10);
    std::vector<std::pair<int, int>> united;
    // Pairs that share one begin never cross.
    const int begin = random.below(n);
    for (int k = random.below(3); k >= 0; --k) united.emplace_back(begin, random.below(n));
    const Split split(n, united);
    if (split.polygons.empty()) continue;
    std::vector<int> all;
    for (const auto& polygon : split.polygons) {
      REQUIRE(polygon.size() >= 2);
      REQUIRE(std::is_sorted(polygon.begin(), polygon.end()));
      all.insert(all.end(), polygon.begin(), polygon.end());
    }
    std::sort(all.begin(), all.end());
    for (int i = 0; i < n; ++i) REQUIRE(all[i] == i);
    REQUIRE(all.size() == static_cast<std::size_t>(n));
  }
}

}  // namespace gvd::test_split_polygon
