// Early iterations without diagrams, last ones with those that were asked for.
// States of a relaxation, level by level.
#include <algorithm>
#include <vector>

#include "gvd/sampling.hpp"
#include "relaxation_state.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_relaxation_state {

double energy_of(const Mesh& mesh, const Diagram& diagram) {
  double energy = 0;
  for (const CellMoments& m : compute_cell_moments(mesh, diagram)) energy += m.energy;
  return energy;
}

TEST_CASE("precision levels: accelerated exact runs begin without diagrams and end as asked for") {
  LloydOptions options;
  options.diagram.chord_tolerance = 1e-3;
  const auto levels = make_precision_levels(options);
  REQUIRE(levels.size() == 2);
  CHECK(levels[0].skips_diagram);
  CHECK_FALSE(levels[1].skips_diagram);
  CHECK(levels[1].diagram.chord_tolerance == 1e-3);
}

TEST_CASE("precision levels: one level for other methods, Lloyd's iteration, and on demand") {
  const auto count = [](auto change) {
    LloydOptions options;
    change(options);
    return make_precision_levels(options).size();
  };
  CHECK(count([](LloydOptions& o) { o.diagram.method = Method::gbgvd; }) == 1);
  CHECK(count([](LloydOptions& o) { o.diagram.method = Method::paper; }) == 1);
  CHECK(count([](LloydOptions& o) { o.acceleration = Acceleration::none; }) == 1);
  CHECK(count([](LloydOptions& o) { o.early_approximation = false; }) == 1);
  CHECK(count([](LloydOptions& o) { o.max_iterations = 0; }) == 1);
}

TEST_CASE("precision levels: the last energy is exact, and methods follow each other in order") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      for (const int most : {0, 1, 3, 60}) {
        CAPTURE(name, seed, most);
        LloydOptions options;
        options.max_iterations = most;
        const LloydResult result = relax_generators(mesh, test::random_generators(mesh, 6, seed), options);
        CHECK(result.iterations.size() <= static_cast<std::size_t>(most));
        CHECK(result.final_energy == Approx(energy_of(mesh, result.diagram)).epsilon(1e-12));
        // Diagrams that are integrated over have more windows, and so other chords. Energies differ by their squares.
        CHECK(result.final_energy == Approx(energy_of(mesh, compute_diagram(mesh, result.generators))).epsilon(1e-7));
        if (result.iterations.empty()) continue;
        CHECK(result.final_energy == result.iterations.back().energy);
        CHECK_FALSE(result.iterations.back().is_sampled);
        CHECK(std::is_partitioned(result.iterations.begin(), result.iterations.end(),
                                  [](const LloydIteration& i) { return i.is_sampled; }));
      }
    }
  }
}

TEST_CASE("precision levels: relaxed generators are not made worse by early iterations") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    LloydOptions options;
    options.early_approximation = false;
    const LloydResult relaxed = relax_generators(mesh, test::random_generators(mesh, 6, 1), options);
    const LloydResult again = relax_generators(mesh, relaxed.generators);
    // Relaxations may end while iterations promise a fall of kSettledFall. In 120 runs, one energy rose, by 3e-5.
    CHECK(again.final_energy <= relaxed.final_energy * (1 + kSettledFall / 10));
    CHECK(again.initial_energy >= again.final_energy);
  }
}

TEST_CASE("state evaluator: the level of diagrams follows the one without") {
  const Mesh mesh = test::make_sphere(3);
  const LloydOptions options;
  const GeneratorConstraints free;
  StateEvaluator states(mesh, options, free);
  CHECK(states.is_first_level());
  CHECK_FALSE(states.is_last_level());
  CHECK(states.precision().skips_diagram);
  states.raise_level();
  CHECK_FALSE(states.is_first_level());
  CHECK(states.is_last_level());
  CHECK_FALSE(states.precision().skips_diagram);
}

TEST_CASE("state evaluator: without early approximation there is one level") {
  const Mesh mesh = test::make_sphere(2);
  LloydOptions options;
  options.early_approximation = false;
  const GeneratorConstraints free;
  StateEvaluator states(mesh, options, free);
  CHECK(states.is_first_level());
  CHECK(states.is_last_level());
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
  states.raise_level();
  const RelaxationState late = states.evaluate(generators, [](double) {});
  CHECK(states.diagrams() == 2);
  CHECK(early.generators == late.generators);
  CHECK(early.energy != late.energy);
  CHECK(early.energy == Approx(late.energy).epsilon(0.01));
}

}  // namespace gvd::test_relaxation_state
