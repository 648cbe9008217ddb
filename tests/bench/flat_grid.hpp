#pragma once

#include <vector>

#include "bench/comparisons.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/planar_voronoi.hpp"

namespace gvd::test {

/// A flat grid with generators, on which every comparator has to find the planar Voronoi diagram.
struct FlatGrid {
  Mesh mesh = make_grid(12, 9);
  std::vector<SurfacePoint> generators = random_generators(mesh, 15, 3);

  /// Areas of the cells within `tolerance` times their size, the error within it.
  void check(const paper::Comparison& found, double tolerance) const {
    std::vector<Vec2> points;
    for (const SurfacePoint& g : generators) points.push_back(position(mesh, g).head<2>());
    const PlanarVoronoi planar(points, 12, 9);
    for (int i = 0; i < 15; ++i) {
      CHECK(found.diagram.cells[GeneratorId(i)].area == Approx(planar.cell_area(i)).epsilon(tolerance));
    }
    CHECK(error_of(paper::Judge(mesh, generators), found.diagram) < tolerance);
    CHECK(found.faults.islands == 0);
    CHECK(found.faults.open_ends == 0);
  }
};

}  // namespace gvd::test
