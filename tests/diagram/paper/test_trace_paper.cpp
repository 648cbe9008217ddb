// The paper's steps as a whole: complete diagrams, and how far growth comes.
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_trace_paper {

TEST_CASE("the paper's steps give complete diagrams on all families, with both fronts") {
  std::int64_t gaps = 0, grown = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : {Front::planar, Front::circle}) {
      for (unsigned seed = 0; seed < 3; ++seed) {
        INFO(name << ", seed " << seed);
        DiagramOptions options;
        options.method = Method::paper;
        options.front = front;
        const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 20, seed), options);
        REQUIRE(check_diagram(mesh, diagram).ok());
        gaps += diagram.report.gaps;
        grown += diagram.report.gaps_grown;
      }
    }
  }
  CHECK(gaps > 500);
  CHECK(2 * grown > gaps);
  CHECK(grown < gaps);
}

TEST_CASE("the paper's steps work with exact distances too, as every solver with every tracer") {
  const Mesh mesh = test::make_torus(24, 12);
  DiagramOptions options;
  options.method = {Solver::windows, Tracer::paper};
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 10, 1), options);
  CHECK(check_diagram(mesh, diagram).ok());
}

}  // namespace gvd::test_trace_paper
