#include <cstdint>
#include <vector>

#include "gvd/error.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "support/catch.hpp"

namespace gvd::test_repair_steps {

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

TEST_CASE("defect log: a defect is counted, described and told") {
  DefectLog log(DefectPolicy::repair);
  log.add(DefectKind::duplicate_faces, 2, 7, "2 faces are there twice", "removed");
  const DefectReport& report = log.report();
  REQUIRE(report.defects.size() == 1);
  CHECK(report.defects[0].first == 7);
  CHECK(report.defects[0].message == "2 faces are there twice: removed");
  CHECK(report.messages == std::vector<std::string>{"2 faces are there twice: removed"});
  CHECK(report.count(DefectKind::duplicate_faces) == 2);
  CHECK(report.count(DefectKind::unused_vertices) == 0);
}

TEST_CASE("defect log: a count of zero is no defect under any policy") {
  for (const DefectPolicy policy : {DefectPolicy::error, DefectPolicy::repair, DefectPolicy::largest}) {
    DefectLog log(policy);
    log.add(DefectKind::unused_vertices, 0, -1, "nothing", "removed");
    CHECK(log.report().defects.empty());
    CHECK(log.report().messages.empty());
  }
}

TEST_CASE("defect log: the first defect is refused where none is allowed") {
  DefectLog log(DefectPolicy::error);
  try {
    log.add(DefectKind::unused_vertices, 1, 3, "1 vertex is in no face", "removed");
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::precondition);
    CHECK(error.element() == 3);
    CHECK_THAT(error.what(), Catch::Matchers::StartsWith("1 vertex is in no face"));
  }
}

TEST_CASE("defect kinds have names for reports") {
  CHECK(name_of(DefectKind::unwelded_vertices) == "unwelded_vertices");
  CHECK(name_of(DefectKind::nonmanifold_edges) == "nonmanifold_edges");
  CHECK(name_of(DefectKind::dropped_components) == "dropped_components");
  CHECK(name_of(DefectKind::one_sided_edges) == "one_sided_edges");
  CHECK(name_of(DefectKind::zero_area_components) == "zero_area_components");
}

}  // namespace gvd::test_repair_steps
