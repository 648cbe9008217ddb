#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "geodesic/marching/fast_marching.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_methods {

const std::vector<Method> kMethods{{Solver::windows, Tracer::envelope},     {Solver::windows, Tracer::growth},
                                   {Solver::windows, Tracer::paper},        {Solver::fast_marching, Tracer::envelope},
                                   {Solver::fast_marching, Tracer::growth}, {Solver::fast_marching, Tracer::paper}};

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

TEST_CASE("the three methods with names: their solvers and tracers") {
  CHECK(Method::exact == kMethods[0]);
  CHECK(Method::gbgvd == kMethods[4]);
  CHECK(Method::paper == kMethods[5]);
}

TEST_CASE("the paper's method has planar fronts unless the options name another, and all others have circles") {
  for (const Method& method : kMethods) {
    DiagramOptions options;
    options.method = method;
    CHECK(options.chosen_front() == (method == Method::paper ? Front::planar : Front::circle));
    for (const Front front : {Front::planar, Front::circle}) {
      options.front = front;
      CHECK(options.chosen_front() == front);
    }
  }
  const Mesh mesh = test::make_bumpy_sphere(2, 1);
  const auto generators = test::random_generators(mesh, 12, 8);
  const auto length = [&](std::optional<Front> front) {
    DiagramOptions options;
    options.method = Method::paper;
    options.front = front;
    return compute_diagram(mesh, generators, options).length;
  };
  CHECK(length({}) == length(Front::planar));
  CHECK(length({}) != length(Front::circle));
}

TEST_CASE("the paper's method has the paper's priority queue, and the others have buckets") {
  int different = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 20, 3);
    const WorkingMesh working(mesh, generators);
    const auto entries = [&](auto marcher, Front front) {
      return static_cast<std::int64_t>(marcher(working, front, {}).table.entry_count());
    };
    const auto reported = [&, &surface = mesh](Method method) {
      return diagram_by(surface, generators, method).report.table_entries;
    };
    const auto in_order = entries(march_in_order, Front::planar);
    CHECK(reported(Method::paper) == in_order);
    CHECK(reported(Method::gbgvd) == entries(march, Front::circle));
    different += in_order != entries(march, Front::planar) ? 1 : 0;
  }
  CHECK(different > 0);
}

TEST_CASE("on a flat mesh all find the same straight bisector") {
  const Mesh mesh = test::make_grid(9, 8);
  const auto generators = test::random_generators(mesh, 2, 5);
  const double length = diagram_by(mesh, generators, Method::exact).length;
  for (const Method& method : kMethods) {
    const Diagram diagram = diagram_by(mesh, generators, method);
    CHECK(diagram.bisectors.size() == 1);
    // The paper's segments zigzag: distances are taken to be linear in a face, and each edge takes the mean of two
    // faces.
    CHECK(diagram.length == Approx(length).epsilon(method.tracer == Tracer::paper ? 0.1 : 2e-3));
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
