#include <cstdint>
#include <vector>

#include "mesh/repair/work_polygons.hpp"
#include "support/catch.hpp"

namespace gvd::test_work_polygons {

std::vector<std::int32_t> corners_of(const WorkPolygons& work, std::size_t p) {
  const auto polygon = work.polygon(p);
  return {polygon.begin(), polygon.end()};
}

void add(WorkPolygons& work, const std::vector<std::int32_t>& corners, std::int32_t from) {
  work.corners.insert(work.corners.end(), corners.begin(), corners.end());
  work.close(from);
}

TEST_CASE("work polygons: each one has the corners that were appended since the last one, and its origin") {
  WorkPolygons work;
  CHECK(work.count() == 0);
  add(work, {4, 1, 2}, 7);
  add(work, {3, 2, 1, 0, 8, 9}, 9);
  add(work, {5, 6, 7}, 9);  // two parts of one polygon of the soup
  REQUIRE(work.count() == 3);
  CHECK(corners_of(work, 0) == std::vector<std::int32_t>{4, 1, 2});
  CHECK(corners_of(work, 1) == std::vector<std::int32_t>{3, 2, 1, 0, 8, 9});
  CHECK(corners_of(work, 2) == std::vector<std::int32_t>{5, 6, 7});
  CHECK(work.origin == std::vector<std::int32_t>{7, 9, 9});
}

TEST_CASE("work polygons: corners that belong to no polygon yet change none, and a polygon may be empty") {
  WorkPolygons work;
  add(work, {0, 1, 2}, 0);
  work.corners.push_back(3);
  CHECK(work.count() == 1);
  CHECK(corners_of(work, 0).size() == 3);
  work.close(1);
  CHECK(corners_of(work, 1) == std::vector<std::int32_t>{3});
  work.close(2);
  CHECK(work.polygon(2).empty());
}

}  // namespace gvd::test_work_polygons
