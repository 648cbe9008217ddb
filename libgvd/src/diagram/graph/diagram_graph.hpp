#pragma once

#include "base/parallel_chunks.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "gvd/diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// What a tracer hands over: how the bisectors cross the edges and run through the faces of the working mesh.
struct TracedDiagram {
  NearestLabels labels;
  Crossings crossings;
  FaceDiagram faces;
  std::vector<VertexId> moved;                          ///< vertices whose label growth changed
  IdVector<GeneratorId, std::int32_t> cell_components;  ///< 1 where a cell is connected
};

/// Follows the arcs from branch point to branch point and fills in bisectors, branch points and their length, in the
/// input mesh's faces, as the first half of the step "cells"; their points by several threads. Cost: O(k) for k arcs.
void trace_bisectors(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                     Diagram& diagram);

/// Fills in face labels, pieces and cells, as the second half of the step "cells"; by several threads. Cost: O(n).
void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                   Diagram& diagram);

/// The point of the input mesh where a crossing of the working mesh lies.
SurfacePoint crossing_point(const WorkingMesh& working, const Crossing& crossing);

}  // namespace gvd
