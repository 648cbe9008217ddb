#pragma once

#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "geodesic/field/generator_table.hpp"
#include "gvd/progress.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Where one face says that a crossing lies.
struct CrossingEstimate {
  CrossingId crossing;
  double t;  ///< parameter along the edge's halfedge
};

/// Refines the crossings of every face that a single bisector runs through: both generators are unfolded into the
/// face's plane, and the bisector becomes the perpendicular bisector of their two images.
///
/// Source: section 4.2 (refinement by unfolding). An estimate that leaves its edge is not given.
/// Returns at most two estimates a crossing, one from each face, ascending by face. Reports the third quarter of the
/// step "bisectors". Cost: O(k) for k crossings.
std::vector<CrossingEstimate> refine_bisectors(const WorkingMesh& working, const GeneratorTable& table,
                                               const NearestLabels& labels, const Crossings& crossings,
                                               const Progress& progress = {});

}  // namespace gvd
