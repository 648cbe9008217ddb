#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/barycentric.hpp"

namespace gvd {

/// The sides of the triangle itself, where no other function follows.
inline constexpr std::size_t kTriangleSide = static_cast<std::size_t>(-1);

/// A part of a triangle in which one of several functions is the least: a convex polygon.
struct EnvelopePart {
  std::size_t function = 0;
  std::vector<Bary> corners;        ///< counter-clockwise
  std::vector<std::size_t> across;  ///< of the side after each corner: the function beyond it, or kTriangleSide
};

/// The lower envelope of functions that are linear over a triangle. `values`: of each, at the three corners.
/// Where functions are equal, the first one counts. The parts do not overlap and cover the triangle, up to rounding.
/// Cost: O(k c + c^3) for k functions, c of which are not above another one everywhere.
std::vector<EnvelopePart> lower_envelope(const std::vector<std::array<double, 3>>& values);

}  // namespace gvd
