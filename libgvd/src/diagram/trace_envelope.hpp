#pragma once

#include "diagram/diagram_graph.hpp"
#include "geodesic/distance_field.hpp"

namespace gvd {

/// Traces the diagram of a distance field, as exactly as the field is: crossings are the corners of the lower envelope
/// on each edge, once for both faces; every face is closed by its assembly; arcs are bent until they are within
/// `tolerance` (mesh units) of the bisectors.
///
/// Reports the steps "bisectors" and "growth". Cost: O(n + k) for k points of the bisectors.
TracedDiagram trace_envelope(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field,
                             double tolerance, const Progress& progress, DiagramReport& report);

}  // namespace gvd
