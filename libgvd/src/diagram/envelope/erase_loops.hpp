#pragma once

#include <array>
#include <vector>

namespace gvd {

/// Takes the loops out of a polyline, given in barycentric coordinates: where it meets itself, it goes on from there
/// the way that it goes when it leaves the place for the last time. Its ends stay; what is left is a part of what was
/// there, and meets itself nowhere, to rounding.
///
/// Where a bisector turns back sharply, points that are found across a chord may lie on the wrong one of its two legs,
/// and the polyline through them goes to and fro.
/// Cost: O(n^2) for n points and each loop. False, and nothing is done, where there is no loop, or where there are more than 1000
/// points.
bool erase_loops(std::vector<std::array<double, 3>>& polyline);

}  // namespace gvd
