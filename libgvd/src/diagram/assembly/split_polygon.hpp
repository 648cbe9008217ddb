#pragma once

#include <vector>

#include "diagram/assembly/face_polygon.hpp"
#include "diagram/assembly/label_intervals.hpp"

namespace gvd {

/// Splits a polygon along every piece that several of its intervals belong to: what lies on the two sides of the piece
/// is assembled independently. Intervals next to each other do not split.
/// Returns: the smaller polygons, which keep the order of the corners; none where there is nothing to split.
/// Cost: O(k log k) for k corners.
std::vector<FacePolygon> split_at_united_intervals(const FacePolygon& polygon, LabelIntervals& intervals);

}  // namespace gvd
