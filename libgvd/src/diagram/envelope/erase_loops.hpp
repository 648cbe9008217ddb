#pragma once

#include <vector>

#include "base/barycentric.hpp"

namespace gvd {

/// Erases the loops of a polyline in barycentric coordinates. At an intersection with itself, the polyline continues
/// along the last of its segments there. Its ends stay. The result is a part of the polyline, and does not intersect
/// itself beyond rounding.
///
/// Loops occur where a bisector turns back sharply: points found across a chord may then lie on either of its two
/// branches, and the polyline through them alternates between these.
/// Returns: false, and nothing changes, where there is no loop, or where there are more than 1000 points.
/// Cost: O(n^2) for n points, for each round of erasing; one or two are the rule.
bool erase_loops(std::vector<Bary>& polyline);

}  // namespace gvd
