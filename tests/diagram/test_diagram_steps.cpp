// The schedule of progress: what a run reports is what gvd/diagram_steps.hpp says.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_diagram_steps {

/// The steps of a run in the order in which they are first named.
std::vector<std::string> steps_in_order(const Method& method) {
  const Mesh mesh = test::make_sphere(3);
  std::vector<std::string> steps;
  DiagramOptions options;
  options.method = method;
  options.progress = [&](std::string_view step, double) {
    if (std::find(steps.begin(), steps.end(), step) == steps.end()) steps.emplace_back(step);
    return true;
  };
  compute_diagram(mesh, test::random_generators(mesh, 30, 4), options);
  return steps;
}

TEST_CASE("each method names its steps in the order of the schedule") {
  using Steps = std::vector<std::string>;
  CHECK(steps_in_order(Method::exact) == Steps{"working mesh", "distances", "bisectors", "faces", "cells"});
  CHECK(steps_in_order(Method::gbgvd) == Steps{"working mesh", "distances", "bisectors", "growth", "cells"});
  CHECK(steps_in_order({Solver::windows, Tracer::growth}) ==
        Steps{"working mesh", "distances", "tables", "bisectors", "growth", "cells"});
  CHECK(steps_in_order({Solver::fast_marching, Tracer::envelope}) ==
        Steps{"working mesh", "distances", "bisectors", "faces", "cells"});
  for (const Method& method : {Method::exact, Method::gbgvd}) {
    auto next = steps::kAll.begin();
    for (const std::string& step : steps_in_order(method)) {
      next = std::find(next, steps::kAll.end(), step);
      REQUIRE(next != steps::kAll.end());
    }
  }
}

TEST_CASE("the names of the steps differ, and parts lie within their step") {
  CHECK(std::set<std::string_view>(steps::kAll.begin(), steps::kAll.end()).size() == steps::kAll.size());
  for (const StepPart& part : {steps::kLabels, steps::kCrossings, steps::kCrossingsAgain, steps::kRefinement,
                               steps::kAssembly, steps::kPolylines, steps::kVerticesAndEdges, steps::kPieces}) {
    CHECK(std::find(steps::kAll.begin(), steps::kAll.end(), part.name) != steps::kAll.end());
    CHECK((0 <= part.from && part.from <= part.to && part.to <= 1));
  }
}

TEST_CASE("a part of a step reports fractions between its ends") {
  std::vector<double> fractions;
  const Progress progress = [&](std::string_view step, double fraction) {
    CHECK(step == "some step");
    return fractions.push_back(fraction), true;
  };
  for (const double done : {0.0, 0.5, 1.0}) report_progress(progress, StepPart{"some step", 0.5, 0.75}, done);
  CHECK(fractions == std::vector<double>{0.5, 0.625, 0.75});
  CHECK_NOTHROW(report_progress(Progress(), StepPart{"some step"}, 0.5));
  const Progress cancel = [](std::string_view, double) { return false; };
  CHECK_THROWS_AS(report_progress(cancel, StepPart{"some step"}, 0.5), Error);
}

}  // namespace gvd::test_diagram_steps
