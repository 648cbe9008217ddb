#pragma once

#include "diagram/growth/growing_end.hpp"
#include "diagram/growth/growth_input.hpp"

namespace gvd {

/// Predicted distance from a point where two ends meet to its three generators, mesh units: the mean of the distances
/// to their images (section 4.3). `first` is the left one of the two. Each end has an image of the generator between
/// them; its distance is the mean of these two.
double branch_distance(const GrowingEnd& first, const GrowingEnd& second, const Vec2& point);

/// Whether a point where two ends meet may be a branch point: equally far from its three generators, and farther from
/// all others whose distances the face's table holds (section 3, second principle).
///
/// Two distances count as equal if they differ by at most kEquidistance face sides. Cost: O(entries of the table).
bool accept_branch(const GrowthInput& input, const GrowingEnd& first, const GrowingEnd& second, const Vec2& point);

}  // namespace gvd
