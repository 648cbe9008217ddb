#pragma once

#include <cstdint>

#include "geodesic/field/generator_table.hpp"
#include "gvd/front.hpp"
#include "gvd/progress.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// What the adapted fast marching leaves behind.
struct FastMarchingResult {
  GeneratorTable table;
  double offset_step;       ///< generator g's distances carry a symbolic offset of (g + 1) offset_step, mesh units
  std::int64_t events = 0;  ///< triangle events that propagated
};

/// Distances from all generators at once, by triangle events in the order of the sum of the three corner distances;
/// every triangle keeps a table of the generators that may own a part of it, and a generator that another one dominates
/// there goes no further.
///
/// Source: section 4.1 of the paper. Distances are stored once a vertex and generator, so that neighbouring triangles
/// can't disagree; an improved distance sends the triangles round it through the queue again, so the result does not
/// depend on the queue's order.
/// Cost: O(n) events on an average.
FastMarchingResult march(const WorkingMesh& working, Front front, const Progress& progress);

}  // namespace gvd
