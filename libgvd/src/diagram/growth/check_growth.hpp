#pragma once

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "diagram/growth/growth.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Whether a grown gap is consistent; fills in `grown.labels` if it is. Nothing that the growth computed is trusted.
///
/// Properties: (1) arcs and nodes fit each other (`check_gap_nodes`); (2) along each edge crossings keep their distance
/// and cells follow each other; (3) the labels of all vertices agree with the crossings (`find_moved_labels`);
/// (4) around branch points the arcs have the order of their cells, and no two cross (`check_gap_arcs`).
/// Source: none; the paper takes the result of growth as it is (section 4.3).
bool check_growth(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
                  GrownGap& grown);

}  // namespace gvd
