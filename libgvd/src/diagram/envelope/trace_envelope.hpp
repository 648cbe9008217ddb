#pragma once

#include "base/parallel_chunks.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "geodesic/field/distance_field.hpp"
#include "gvd/diagram.hpp"

namespace gvd {

/// Traces the diagram of a distance field, as exactly as the field is: crossings are the corners of the lower envelope
/// on each edge, once for both faces; every face is closed by its assembly; arcs are bent until they are within
/// `tolerance` (mesh units) of the bisectors.
///
/// Edges are crossed and faces closed by several threads; the distance field has to bear that.
/// Reports the steps "bisectors" and "faces". Cost: O(n + k) for k points of the bisectors.
TracedDiagram trace_envelope(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field,
                             double tolerance, const ParallelChunks& parallel, DiagramReport& report);

}  // namespace gvd
