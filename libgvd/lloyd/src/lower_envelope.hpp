#pragma once

#include <array>
#include <cstddef>
#include <span>
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

/// Computes lower envelopes of functions that are linear over a triangle. All of them use the same memory.
class LowerEnvelope {
 public:
  /// The parts of the envelope. `values`: of each function, at the three corners. Where functions are equal, the first
  /// one counts. The parts do not overlap and cover the triangle, up to rounding. They are valid until the next call.
  /// Cost: O(k c + c^3) for k functions, c of which are not above another one everywhere.
  std::span<const EnvelopePart> compute(const std::vector<std::array<double, 3>>& values);

 private:
  using Function = std::array<double, 3>;

  void list_candidates(const std::vector<Function>& values);
  void clip(const std::vector<Function>& values, EnvelopePart& part, std::size_t other);

  std::vector<std::size_t> candidates_;  // functions that no other one is below everywhere
  std::vector<EnvelopePart> parts_;      // those in use come first
  EnvelopePart rest_;                    // what is left of the part that is cut
  std::vector<double> excess_;           // the other function less the part's, at its corners
};

}  // namespace gvd
