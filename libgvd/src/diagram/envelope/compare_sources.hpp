#pragma once

#include <array>

#include "geodesic/field/distance_field.hpp"

namespace gvd {

/// Which of two sources of an edge is nearer on an interval, by their straight paths.
enum class Nearer { first, second, open };

/// Compares two sources on [begin, end]. `open`: the nearer one may change in the interval.
/// Cost: O(1), without a root of the distances' difference.
Nearer compare_sources(const EdgeSource& first, const EdgeSource& second, double begin, double end);

/// The positions on the edge's line where the straight paths of two sources may be equally long, ascending; -1 stands
/// for none. They include all such positions, to half of the digits where the two distances touch. Some are none.
/// `unit`: a power of two that brings the edge's length near 1, so that sixth powers of it stay in range.
std::array<double, 2> equidistant_positions(const EdgeSource& first, const EdgeSource& second, double unit);

/// Improves such a position by Newton's steps, inside of (begin, end).
double refine_equidistant(const EdgeSource& first, const EdgeSource& second, double begin, double end, double position);

}  // namespace gvd
