// States of a relaxation, level by level.
#include <algorithm>
#include <vector>

#include "state_evaluator.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_state_evaluator {

TEST_CASE("state evaluator: levels follow each other, and early ones can be skipped") {
  const Mesh mesh = test::make_sphere(3);
  const LloydOptions options;
  const GeneratorConstraints free;
  StateEvaluator states(mesh, options, free);
  CHECK(states.is_first_level());
  CHECK(states.is_early_level());
  CHECK(states.precision().skips_diagram);
  states.skip_early_levels();
  CHECK_FALSE(states.is_first_level());
  CHECK_FALSE(states.is_early_level());
  CHECK_FALSE(states.is_last_level());
  CHECK_FALSE(states.precision().skips_diagram);
  states.skip_early_levels();
  CHECK_FALSE(states.is_last_level());
  states.raise_level();
  CHECK(states.is_last_level());
}

TEST_CASE("state evaluator: without early approximation there is one level") {
  const Mesh mesh = test::make_sphere(2);
  LloydOptions options;
  options.early_approximation = false;
  const GeneratorConstraints free;
  StateEvaluator states(mesh, options, free);
  CHECK(states.is_first_level());
  CHECK(states.is_last_level());
  CHECK_FALSE(states.is_early_level());
}

TEST_CASE("state evaluator: diagrams are counted, and each reports the fraction that is done") {
  const Mesh mesh = test::make_sphere(3);
  const LloydOptions options;
  const GeneratorConstraints free;
  StateEvaluator states(mesh, options, free);
  const std::vector<SurfacePoint> generators = test::random_generators(mesh, 6, 1);
  std::vector<double> fractions;
  const RelaxationState early = states.evaluate(generators, [&](double done) { fractions.push_back(done); });
  REQUIRE_FALSE(fractions.empty());
  CHECK(*std::min_element(fractions.begin(), fractions.end()) >= 0);
  CHECK(*std::max_element(fractions.begin(), fractions.end()) == 1);
  states.skip_early_levels();
  const RelaxationState late = states.evaluate(generators, [](double) {});
  CHECK(states.diagrams() == 2);
  CHECK(early.generators == late.generators);
  CHECK(early.energy != late.energy);
  CHECK(early.energy == Approx(late.energy).epsilon(0.01));
}

}  // namespace gvd::test_state_evaluator
