#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/barycentric.hpp"

namespace gvd {

/// Stands for a side of the triangle, beyond which there is no other function.
inline constexpr std::size_t kTriangleSide = static_cast<std::size_t>(-1);

/// A part of a triangle in which one of several functions is the least: a convex polygon.
struct EnvelopePart {
  std::size_t function = 0;
  std::vector<Bary> corners;        ///< counter-clockwise
  std::vector<std::size_t> across;  ///< for the side after each corner: the function beyond it, or kTriangleSide
};

/// Computes lower envelopes of functions that are linear over a triangle. Reuses its memory from call to call.
class LowerEnvelope {
 public:
  /// Returns the parts of the envelope. `values`: the values of each function at the three corners. Among equal
  /// functions, the first one counts. The parts do not overlap and cover the triangle, up to rounding. They are valid
  /// until the next call.
  /// Cost: O(k c + c^3) for k functions and c candidates, which are the functions that no other function is below
  /// everywhere.
  std::span<const EnvelopePart> compute(const std::vector<std::array<double, 3>>& values);

 private:
  using Function = std::array<double, 3>;

  void list_candidates(const std::vector<Function>& values);
  bool are_many() const;
  std::size_t find_clipping(const EnvelopePart& part, std::size_t own, std::size_t from) const;
  void clip(const std::vector<Function>& values, EnvelopePart& part, std::size_t other);

  std::vector<std::size_t> candidates_;                  // functions that no other function is below everywhere
  std::array<std::vector<double>, 3> candidate_values_;  // at each corner, if there are many
  std::vector<EnvelopePart> parts_;                      // the parts in use come first
  EnvelopePart rest_;                                    // the rest of the part after a cut
  std::vector<double> excess_;                           // the other function minus the part's, at the part's corners
};

}  // namespace gvd
