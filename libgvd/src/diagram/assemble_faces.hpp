#pragma once

#include "diagram/diagram_graph.hpp"
#include "diagram/distance_form.hpp"
#include "geodesic/fast_marching.hpp"

namespace gvd {

/// The distance forms of those generators that stand in a face's table or round its boundary.
std::vector<DistanceForm> face_forms(const Mesh& mesh, const GeneratorTable& table, const NearestLabels& labels, FaceId f,
                                     const std::vector<BoundaryCrossing>& boundary, Front front);

/// Joins the crossings in every face. Cost: O(k) for k faces near bisectors.
FaceDiagram assemble_faces(const WorkingMesh& working, const GeneratorTable& table, const NearestLabels& labels,
                           const Crossings& crossings, Front front);

}  // namespace gvd
