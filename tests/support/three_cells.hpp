#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagram/check_diagram.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test {

/// A flat grid with three cells and one branch point at (3.5, 2.9), without ties.
struct ThreeCells {
  Mesh mesh = test::make_grid(8, 8);
  Diagram diagram;

  ThreeCells() {
    std::vector<SurfacePoint> generators;
    for (const int v : {1 * 9 + 1, 1 * 9 + 6, 6 * 9 + 4}) generators.push_back(vertex_point(mesh, VertexId(v)));
    diagram = compute_diagram(mesh, generators);
    REQUIRE(diagram.branch_points.size() == 1);
  }

  /// The violations that a part of the check adds: of its ids, generators and so on.
  template <class Check, class... More>
  std::vector<std::string> run(const Check& check, const More&... more) const {
    Violations violations;
    check(mesh, diagram, more..., violations);
    return violations.take();
  }

  Cell& cell(int g) { return diagram.cells[GeneratorId(g)]; }
  Bisector& bisector(int b) { return diagram.bisectors[BisectorId(b)]; }
};

}  // namespace gvd::test
