#include <algorithm>

#include "diagram/assembly/split_polygon.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"
#include "support/random.hpp"

using namespace gvd;

namespace {

/// A polygon of n corners, of which these intervals are united.
struct Split {
  std::vector<BoundaryCrossing> boundary;
  test::PointDistances distances;
  std::vector<std::vector<int>> parts;  // the intervals of each

  Split(int n, const std::vector<std::pair<int, int>>& united) {
    std::vector<std::pair<double, int>> positions;
    for (int i = 0; i < n; ++i) positions.emplace_back(3.0 * i / n, i);
    boundary = test::boundary_of(positions);
    LabelIntervals intervals(boundary, distances);
    for (const auto& [i, j] : united) intervals.unite(i, j);
    for (const FacePolygon& part : split_at_united_intervals(test::polygon_of(boundary), intervals)) {
      auto& own = parts.emplace_back();
      for (const PolygonCorner& corner : part) own.push_back(corner.interval);
    }
  }
};

using Parts = std::vector<std::vector<int>>;

}  // namespace

TEST_CASE("without united intervals there is nothing to split") {
  CHECK(Split(3, {}).parts.empty());
  CHECK(Split(6, {}).parts.empty());
}

TEST_CASE("neighbours, also over the last corner, do not split") {
  CHECK(Split(5, {{1, 2}}).parts.empty());
  CHECK(Split(5, {{4, 0}}).parts.empty());
}

TEST_CASE("two united intervals split the polygon in two, each with one of them") {
  CHECK(Split(6, {{1, 4}}).parts == Parts{{2, 3, 4}, {0, 1, 5}});
  CHECK(Split(4, {{0, 2}}).parts == Parts{{1, 2}, {0, 3}});
}

TEST_CASE("three intervals of one piece split off two parts, nested pieces the inner one first") {
  CHECK(Split(6, {{0, 2}, {2, 4}}).parts == Parts{{1, 2}, {3, 4}, {0, 5}});
  CHECK(Split(8, {{0, 6}, {2, 4}}).parts == Parts{{3, 4}, {1, 2, 5, 6}, {0, 7}});
}

TEST_CASE("random nested pieces: every interval is in one part, and every part has two corners or more") {
  test::Random random(7);
  for (int round = 0; round < 500; ++round) {
    const int n = 4 + random.below(10);
    std::vector<std::pair<int, int>> united;
    // Pairs that share one begin never cross.
    const int begin = random.below(n);
    for (int k = random.below(3); k >= 0; --k) united.emplace_back(begin, random.below(n));
    const Split split(n, united);
    if (split.parts.empty()) continue;
    std::vector<int> all;
    for (const auto& part : split.parts) {
      REQUIRE(part.size() >= 2);
      REQUIRE(std::is_sorted(part.begin(), part.end()));
      all.insert(all.end(), part.begin(), part.end());
    }
    std::sort(all.begin(), all.end());
    for (int i = 0; i < n; ++i) REQUIRE(all[static_cast<std::size_t>(i)] == i);
    REQUIRE(all.size() == static_cast<std::size_t>(n));
  }
}
