#pragma once

#include <cstdint>

#include "geodesic/generator_table.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "gvd/front.hpp"
#include "gvd/progress.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

struct FastMarchingResult {
  GeneratorTable table;
  SymbolicOffset offset;    ///< contained in the table's distances
  std::int64_t events = 0;  ///< triangle events that propagated
};

/// Computes the distances from all generators at once. An event is a triangle and a generator; events are handled in
/// nearly ascending order of the sum of the three corner distances. Every triangle has a table of the generators that
/// may be nearest in a part of it. A generator does not propagate from a triangle in which another one dominates it.
///
/// Source: section 4.1 of the paper. Deviations: each distance is stored once per vertex and generator, so that
/// neighbouring triangles can't disagree; an improved distance queues the triangles round its vertex again; a ring of
/// buckets replaces the priority queue, so that an event may come before others that are nearer by a mean edge length.
/// Throws: gvd::Error (interrupted) if `progress` cancels. Cost: O(n) events on average.
FastMarchingResult march(const WorkingMesh& working, Front front, const Progress& progress);

/// The same with the paper's priority queue: the event with the least sum is always next. Other generators may be
/// stopped than by `march`, or in other triangles. Improvements of a distance by less than a millionth are ignored;
/// otherwise, marching over fans of needles would not end in a reasonable time. Cost: O(n log n) on average.
FastMarchingResult march_in_order(const WorkingMesh& working, Front front, const Progress& progress);

}  // namespace gvd
