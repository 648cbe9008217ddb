#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/vec.hpp"

namespace gvd::io {

/// A bisector as a polyline in space.
struct BisectorLine {
  GeneratorId left;
  GeneratorId right;
  std::vector<Vec3> points;      ///< two or more; a closed line repeats its first point at its end
  std::vector<double> distance;  ///< at each point, linear in its face; infinity where no generator reaches
};

/// The bisectors of the diagram in its order, without those of a single point; none without a diagram. Cost: O(n).
std::vector<BisectorLine> collect_bisector_lines(const LabelledMesh& mesh);

}  // namespace gvd::io
