#pragma once

#include "diagram/face_diagram.hpp"
#include "diagram/source_metric.hpp"

namespace gvd {

/// Bends a straight arc into the bisector of its two generators: appends inner points to `points` until no straight
/// piece is farther than `tolerance` (mesh units) from it.
///
/// The bisector is made of pieces of hyperbolas, straight where the two offsets agree, with a corner wherever the
/// source that reaches it first changes. A straight piece that is too far off, as the bisector's directions at its ends
/// and a look at its middle or its quarters show, is parted by a point of the bisector. `begin` and `end` are the arc's
/// ends in the face that the metric has entered.
/// Cost: O(points); three evaluations of both distances where the bisector is straight.
void bend_arc(const SourceMetric& metric, const FaceArc& arc, const FaceMetric::Bary& begin,
              const FaceMetric::Bary& end, double tolerance, std::vector<FaceMetric::Bary>& points);

}  // namespace gvd
