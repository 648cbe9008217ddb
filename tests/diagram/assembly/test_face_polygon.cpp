#include <algorithm>
#include <cmath>

#include "diagram/assembly/face_polygon.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"
#include "support/random.hpp"

namespace gvd::test_face_polygon {

/// The point of the face at these affine coordinates.
Bary at_affine(double x, double y) { return {1 - x - y, x, y}; }

const std::vector<Bary> kSquare{at_affine(0.1, 0.1), at_affine(0.4, 0.1), at_affine(0.4, 0.4), at_affine(0.1, 0.4)};

TEST_CASE("points on one line are convex, in their order and back") {
  CHECK(is_convex({at_affine(0, 0), at_affine(0.5, 0), at_affine(1, 0)}, 0));
  CHECK(is_convex({at_affine(0.2, 0.2), at_affine(0.2, 0.2), at_affine(0.2, 0.2)}, 0));
}

TEST_CASE("a square is convex counter-clockwise, and not clockwise or with a dent") {
  CHECK(is_convex(kSquare, 0));
  CHECK_FALSE(is_convex({kSquare.rbegin(), kSquare.rend()}, 0));
  std::vector<Bary> dented = kSquare;
  dented[2] = at_affine(0.2, 0.2);
  CHECK_FALSE(is_convex(dented, 0));
  CHECK_FALSE(is_convex(dented, 1e-3));
}

TEST_CASE("a corner beyond its neighbours' line counts as convex up to the tolerance") {
  const auto with_dent = [](double depth) {
    std::vector<Bary> polygon = kSquare;
    polygon.insert(polygon.begin() + 1, at_affine(0.25, 0.1 + depth));
    return polygon;
  };
  CHECK(is_convex(with_dent(0), 0));
  CHECK_FALSE(is_convex(with_dent(1e-12), 0));
  CHECK(is_convex(with_dent(1e-12), 4e-12));
  CHECK_FALSE(is_convex(with_dent(1e-11), 4e-12));
}

TEST_CASE("inside: the corners and sides belong to a polygon, what lies outside of the face does not") {
  const auto boundary = test::boundary_of({{0.5, 1}, {1.5, 2}, {2.5, 0}});
  const FacePolygon polygon = test::polygon_of(boundary);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(is_inside(polygon, polygon[i].bary, 0));
    CHECK(is_inside(polygon, midpoint(polygon, i), 1e-15));
  }
  CHECK(is_inside(polygon, centre(polygon), 0));
  CHECK_FALSE(is_inside(polygon, at_affine(0.05, 0.05), 0));
  CHECK_FALSE(is_inside(polygon, {0.6, 0.5, -0.1}, 1));  // however large the tolerance
}

TEST_CASE("crossings of one edge span a polygon without area, and only points of that edge are inside") {
  const FacePolygon polygon = test::polygon_of(test::boundary_of({{0.2, 1}, {0.5, 2}, {0.8, 0}}));
  CHECK(is_inside(polygon, at_affine(0.5, 0), 0));
  CHECK_FALSE(is_inside(polygon, at_affine(0.5, 0.1), 0));
}

TEST_CASE("midpoints, the centre and distances are those of barycentric coordinates") {
  const FacePolygon polygon = test::polygon_of(test::boundary_of({{0.0, 1}, {1.0, 2}, {2.0, 0}}));
  CHECK(midpoint(polygon, 2) == Bary{0.5, 0, 0.5});
  for (const double coordinate : centre(polygon)) CHECK(coordinate == Approx(1.0 / 3));
  CHECK(bary_distance({1, 0, 0}, {0, 1, 0}) == 1);
  CHECK(bary_distance({0, 1, 0}, {0, 0, 1}) == Approx(std::sqrt(2)));
}

const Bary kAnywhere{0.3, 0.3, 0.4};

TEST_CASE("distances that know no paths unite nothing, and no path enters anywhere") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  const test::PointDistances distances;
  LabelIntervals intervals(boundary);
  intervals.unite_by_paths(distances);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) CHECK_FALSE(intervals.are_one_piece(i, j));
    CHECK_FALSE(intervals.path_enters_through(i, kAnywhere, distances));
  }
}

TEST_CASE("intervals of one generator are united where its paths enter, the other's stay apart") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  distances.entries = {0.4, 0.9};  // generator 1 enters through each of its intervals: as its first one says
  LabelIntervals intervals(boundary);
  intervals.unite_by_paths(distances);
  CHECK(intervals.are_one_piece(0, 2));
  CHECK(intervals.are_one_piece(1, 3));
  CHECK_FALSE(intervals.are_one_piece(0, 1));
}

TEST_CASE("a path that enters through another generator's interval unites nothing") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  distances.entries = {1.0, 0.5};  // each through an interval of the other
  LabelIntervals intervals(boundary);
  intervals.unite_by_paths(distances);
  CHECK_FALSE(intervals.are_one_piece(0, 2));
  CHECK_FALSE(intervals.are_one_piece(1, 3));
}

TEST_CASE("the interval over the last corner contains positions on both sides of it") {
  const auto boundary = test::boundary_of({{0.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  for (const double position : {2.6, 2.999, 0.0, 0.4}) {
    distances.entries = {std::nullopt, position};
    LabelIntervals intervals(boundary);
    CHECK(intervals.path_enters_through(1, kAnywhere, distances));
  }
  for (const double position : {0.6, 2.0, 2.4}) {
    distances.entries = {std::nullopt, position};
    LabelIntervals intervals(boundary);
    CHECK_FALSE(intervals.path_enters_through(1, kAnywhere, distances));
  }
}

TEST_CASE("a path enters through every interval of its piece") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  distances.entries = {1.7};
  LabelIntervals intervals(boundary);
  CHECK_FALSE(intervals.path_enters_through(0, kAnywhere, distances));
  intervals.unite(0, 2);
  CHECK(intervals.path_enters_through(0, kAnywhere, distances));
}

TEST_CASE("beside a crossing, the path may enter through the interval beyond it, within rounding") {
  const auto boundary = test::boundary_of({{0.5, 0}, {1.5, 1}, {2.5, 2}});
  test::PointDistances distances;
  const auto enters = [&](double position, int interval) {
    distances.entries = {position, position, position};
    LabelIntervals intervals(boundary);
    return intervals.path_enters_through(interval, kAnywhere, distances);
  };
  CHECK(enters(1.5 + 1e-10, 0));
  CHECK(enters(1.5 - 1e-10, 1));
  CHECK_FALSE(enters(1.5 + 1e-6, 0));
  CHECK_FALSE(enters(1.5 + 1e-10, 2));
  distances.error = 1e-3;  // the two generators nearly coincide
  CHECK(enters(1.5 + 1e-6, 0));
  distances.error = 2;  // rounding may have moved the crossings anywhere
  for (int i = 0; i < 3; ++i) CHECK(enters(0.9, i));
}

TEST_CASE("distance to a crossing is measured round the face") {
  const auto boundary = test::boundary_of({{1e-12, 0}, {1.5, 1}});
  test::PointDistances distances;
  distances.entries = {3 - 1e-12};
  LabelIntervals intervals(boundary);
  CHECK(intervals.path_enters_through(0, kAnywhere, distances));
}

/// A polygon of n corners, of which these intervals are united.
struct Split {
  std::vector<BoundaryCrossing> boundary;
  std::vector<std::vector<int>> polygons;  // the intervals of each

  Split(int n, const std::vector<std::pair<int, int>>& united) {
    std::vector<std::pair<double, int>> positions;
    for (int i = 0; i < n; ++i) positions.emplace_back(3.0 * i / n, i);
    boundary = test::boundary_of(positions);
    LabelIntervals intervals(boundary);
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

}  // namespace gvd::test_face_polygon
