#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::paper {

/// What a comparator leaves wrong, counted and not repaired. Zero is the normal case.
struct Faults {
  /// Components of cells without their generator: the orphans of [28].
  std::int64_t islands = 0;
  double island_area = 0;  ///< square mesh units
  /// Generators that do not lie in their own cell.
  std::int64_t lost_generators = 0;
  /// Ends of bisectors that nothing continues, inside the mesh.
  std::int64_t open_ends = 0;
  /// Faces whose bisectors were joined without a rule of the method: its cap, or no valid branch point.
  std::int64_t forced_faces = 0;
  /// Vertices at which the distances or the heat underflow, so that no cell owns them.
  std::int64_t unreached_vertices = 0;
  double unowned_area = 0;  ///< of pieces without a generator, square mesh units
};

/// What a comparator returns.
struct Comparison {
  /// Filled in: generators, vertex_label, face_label, pieces, bisectors, length; area, components and neighbours of the
  /// cells. Empty: vertex_distance, branch_points, and the other members of the cells. So `compute_error_measure` can
  /// judge it, `check_diagram` can not. Bisectors have no branch points at their ends.
  Diagram diagram;
  double field_ms = 0;    ///< processor time of the distances, or of what stands for them
  double diagram_ms = 0;  ///< processor time of the cells and bisectors, without the collection of `diagram`
  int rounds = 1;         ///< how often cells were computed
  Faults faults;
};

/// A method that the paper compares itself with (sections 2.2 and 5.3 to 5.5), or one of ours beside it.
struct Comparator {
  std::string name;
  std::function<Comparison(const Mesh&, const std::vector<SurfacePoint>&)> run;
};

}  // namespace gvd::paper
