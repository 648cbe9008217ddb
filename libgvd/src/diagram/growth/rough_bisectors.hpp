#pragma once

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "gvd/diagram.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// The crossings of the rough bisectors with the edges: on every half of an edge, the lower envelope of the distances
/// that the generator tables of its two faces hold, from the ends to the midpoint with its auxiliary distance.
///
/// Source: section 4.2 (rough bisectors) and 4.1 (auxiliary distances). A cell that pokes through the inside of an edge
/// whose two ends belong to others shows at the midpoint.
/// Reports the first half of the step "bisectors". Cost: O(k) for the k edges near bisectors.
Crossings find_rough_crossings(const WorkingMesh& working, const GeneratorTable& table, const NearestLabels& labels,
                               Front front, const Progress& progress = {});

/// Crosses the given edges (ascending) at most once, between the labels of their ends.
void cross_at_most_once(const WorkingMesh& working, const GeneratorTable& table, const NearestLabels& labels,
                        Front front, const std::vector<EdgeId>& edges, Crossings& crossings);

}  // namespace gvd
