#pragma once

#include <utility>
#include <vector>

#include "gvd/density.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A straight piece of the bisector of two cells.
struct BisectorSegment {
  GeneratorId left, right;  ///< the lesser one first
  Vec3 from, to;
  double length = 0;   ///< of the bisector that it stands for, mesh units
  double density = 1;  ///< mean over the segment
};

/// The segments of all bisectors of a diagram between different cells, bisector by bisector, sorted by their cells.
/// Cost: O(points), and sorting.
std::vector<BisectorSegment> bisector_segments(const Mesh& mesh, const Diagram& diagram, const Density& density = {});

/// Sorts segments by their cells, and keeps the order of those with the same cells. Cost: O(segments + cells).
void sort_by_cells(std::vector<BisectorSegment>& segments);

/// The pairs of cells that share sorted segments, each pair once, ascending. Cost: O(segments).
std::vector<std::pair<GeneratorId, GeneratorId>> neighbouring_cells(const std::vector<BisectorSegment>& segments);

}  // namespace gvd
