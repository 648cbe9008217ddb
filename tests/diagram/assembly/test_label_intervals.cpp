#include "diagram/assembly/label_intervals.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"

namespace gvd::test_label_intervals {

const Bary kAnywhere{0.3, 0.3, 0.4};

TEST_CASE("distances that know no paths unite nothing, and no path enters anywhere") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  const test::PointDistances distances;
  LabelIntervals intervals(boundary, distances);
  intervals.unite_by_paths();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) CHECK_FALSE(intervals.are_one_piece(i, j));
    CHECK_FALSE(intervals.path_enters_through(i, kAnywhere));
  }
}

TEST_CASE("intervals of one generator are united where its paths enter, the other's stay apart") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  distances.entries = {0.4, 0.9};  // generator 1 enters through each of its intervals: as its first one says
  LabelIntervals intervals(boundary, distances);
  intervals.unite_by_paths();
  CHECK(intervals.are_one_piece(0, 2));
  CHECK(intervals.are_one_piece(1, 3));
  CHECK_FALSE(intervals.are_one_piece(0, 1));
}

TEST_CASE("a path that enters through another generator's interval unites nothing") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  distances.entries = {1.0, 0.5};  // each through an interval of the other
  LabelIntervals intervals(boundary, distances);
  intervals.unite_by_paths();
  CHECK_FALSE(intervals.are_one_piece(0, 2));
  CHECK_FALSE(intervals.are_one_piece(1, 3));
}

TEST_CASE("the interval over the last corner contains positions on both sides of it") {
  const auto boundary = test::boundary_of({{0.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  for (const double position : {2.6, 2.999, 0.0, 0.4}) {
    distances.entries = {std::nullopt, position};
    LabelIntervals intervals(boundary, distances);
    CHECK(intervals.path_enters_through(1, kAnywhere));
  }
  for (const double position : {0.6, 2.0, 2.4}) {
    distances.entries = {std::nullopt, position};
    LabelIntervals intervals(boundary, distances);
    CHECK_FALSE(intervals.path_enters_through(1, kAnywhere));
  }
}

TEST_CASE("a path enters through every interval of its piece") {
  const auto boundary = test::boundary_of({{0.2, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  test::PointDistances distances;
  distances.entries = {1.7};
  LabelIntervals intervals(boundary, distances);
  CHECK_FALSE(intervals.path_enters_through(0, kAnywhere));
  intervals.unite(0, 2);
  CHECK(intervals.path_enters_through(0, kAnywhere));
}

TEST_CASE("beside a crossing, the path may enter through the interval beyond it, within rounding") {
  const auto boundary = test::boundary_of({{0.5, 0}, {1.5, 1}, {2.5, 2}});
  test::PointDistances distances;
  const auto enters = [&](double position, int interval) {
    distances.entries = {position, position, position};
    LabelIntervals intervals(boundary, distances);
    return intervals.path_enters_through(interval, kAnywhere);
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
  LabelIntervals intervals(boundary, distances);
  CHECK(intervals.path_enters_through(0, kAnywhere));
}

}  // namespace gvd::test_label_intervals
