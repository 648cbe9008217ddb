#include <cmath>
#include <cstddef>
#include <limits>

#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_methods {

const std::vector<Method> kMethods{{Solver::windows, Tracer::envelope},
                                   {Solver::windows, Tracer::growth},
                                   {Solver::fast_marching, Tracer::envelope},
                                   {Solver::fast_marching, Tracer::growth}};

Diagram diagram_by(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Method method) {
  DiagramOptions options;
  options.method = method;
  return compute_diagram(mesh, generators, options);
}

TEST_CASE("every solver works with every tracer, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int m : {1, 2, 7, 40}) {
      const auto generators = test::random_generators(mesh, m, 3);
      for (const Method& method : kMethods) {
        INFO(name << ", " << m << " generators, solver " << static_cast<int>(method.solver) << ", tracer "
                  << static_cast<int>(method.tracer));
        const DiagramCheck check = check_diagram(mesh, diagram_by(mesh, generators, method));
        CAPTURE(check.violations);
        REQUIRE(check.ok());
      }
    }
  }
}

TEST_CASE("the two solvers with names, and their tracers") {
  CHECK(Method::exact == kMethods[0]);
  CHECK(Method::gbgvd == kMethods[3]);
}

TEST_CASE("on a flat mesh all four find the same straight bisector") {
  const Mesh mesh = test::make_grid(9, 8);
  const auto generators = test::random_generators(mesh, 2, 5);
  const double length = diagram_by(mesh, generators, Method::exact).length;
  for (const Method& method : kMethods) {
    const Diagram diagram = diagram_by(mesh, generators, method);
    CHECK(diagram.bisectors.size() == 1);
    CHECK(diagram.length == Approx(length).epsilon(2e-3));
  }
}

TEST_CASE("areas by exact distances depend on the tracer only by its straight segments") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const auto generators = test::random_generators(mesh, 12, 8);
  const Diagram envelope = diagram_by(mesh, generators, Method::exact);
  const Diagram growth = diagram_by(mesh, generators, {Solver::windows, Tracer::growth});
  double total = 0, apart = 0;
  for (const Cell& cell : envelope.cells) {
    total += cell.area;
    apart += std::abs(cell.area - growth.cells[cell.generator].area);
  }
  CHECK(apart < 0.01 * total);
  CHECK(apart > 0);  // it was another tracer
}

TEST_CASE("a chord tolerance that is not a number, or below the limit of rounding, is refused") {
  const Mesh mesh = test::make_grid(2, 2);
  for (const double tolerance : {0.0, -1.0, 0.99 * kLeastChordTolerance, std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()}) {
    DiagramOptions options;
    options.chord_tolerance = tolerance;
    try {
      compute_diagram(mesh, test::random_generators(mesh, 2, 1), options);
      FAIL("accepted");
    } catch (const Error& e) {
      CHECK(e.code() == ErrorCode::invalid_option);
    }
  }
}

TEST_CASE("the least chord tolerance ends after a bounded number of segments") {
  const Mesh mesh = test::make_bumpy_sphere(1, 3);
  DiagramOptions options;
  options.chord_tolerance = kLeastChordTolerance;
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 3, 1), options);
  std::size_t points = 0;
  for (const Bisector& bisector : diagram.bisectors) points += bisector.points.size();
  // Some sqrt(1 / 1e-10) points for each mean edge, not the 2^40 of unlimited halving.
  CHECK(points > 10'000);
  CHECK(points < 10'000'000);
}

}  // namespace gvd::test_methods
