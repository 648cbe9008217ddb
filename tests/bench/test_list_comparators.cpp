#include <set>

#include "bench/comparisons.hpp"
#include "judging/judge.hpp"
#include "list_comparators.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_list_comparators {

using namespace paper;

TEST_CASE("every comparator has a name of its own and fills a diagram that the same E judges") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::vertex_points(mesh, 10, 1, 60);
  const Judge judge(mesh, generators);
  std::set<std::string> names;
  for (const Comparator& comparator : list_comparators()) {
    INFO(comparator.name);
    CHECK(names.insert(comparator.name).second);
    const Comparison found = comparator.run(mesh, generators);
    CHECK(found.diagram.generators == generators);
    CHECK(found.diagram.bisectors.size() > 10);
    CHECK(found.diagram.face_label.size() == std::size_t(mesh.face_count()));
    CHECK(found.field_ms + found.diagram_ms > 0);
    const Judgement judgement = judge.judge(found.diagram);
    CHECK(judgement.error.length == Approx(found.diagram.length).epsilon(1e-6));
    CHECK(std::isfinite(judgement.error.error_integral));
    CHECK(double(judgement.wrong_labels) < 0.2 * double(judgement.labelled));
  }
  CHECK(names.size() == 9);
}

TEST_CASE("the exact method has the least error, and windows with straight segments the next") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::vertex_points(mesh, 10, 1, 60);
  const Judge judge(mesh, generators);
  std::vector<double> error;
  for (const Comparator& comparator : list_comparators({{}, false})) {
    error.push_back(judge.judge(comparator.run(mesh, generators).diagram).error.error_integral);
  }
  REQUIRE(error.size() == 8);
  const double exact = error[0], windows = error[4];
  CHECK(exact < windows);
  for (const std::size_t other : {1, 2, 3, 5, 6, 7}) CHECK(windows < error[other]);
}

}  // namespace gvd::test_list_comparators
