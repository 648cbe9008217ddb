// What the log of defects keeps, tells and refuses.
#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "mesh/repair/defect_log.hpp"
#include "support/catch.hpp"

namespace gvd::test_defect_log {

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

}  // namespace gvd::test_defect_log
