#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/features.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Rounds that add generators on creases. Gaps shrink to less than three quarters each time, as a rule: where few
/// generators are given for many creases, the first rounds fill corners and closed curves, and some gaps may stay.
inline constexpr int kCreaseRounds = 12;

/// Adds generators on creases, round by round, so that the dual's edges follow them (see crease_gaps.hpp).
class CreaseFollower {
 public:
  /// Mesh and creases must outlive this. `max_added`: generators in all rounds together. `spacing`: that of evenly
  /// spread generators, mesh units. Cost: O(n).
  CreaseFollower(const Mesh& mesh, const std::vector<CreaseCurve>& creases, std::int64_t max_added, double spacing);

  /// New generators for the largest gaps, at most `may_add`. None where there is no gap, and once the rounds or the
  /// generators are used up: other gaps then stay. Cost: O(n), and O(k m) for k new ones beside m generators.
  std::vector<SurfacePoint> propose(const Diagram& diagram, std::int64_t may_add);

  std::int64_t added() const { return added_; }
  /// Of all creases, mesh units.
  double length() const { return length_; }
  /// Of the parts that the dual of the last `propose` does not follow, mesh units, in [0, length()].
  double gap_length() const { return gap_length_; }

 private:
  const Mesh& mesh_;
  const std::vector<CreaseCurve>& curves_;
  double length_ = 0;
  double gap_length_ = 0;
  std::int64_t max_added_;
  double spacing_;
  std::int64_t added_ = 0;
  int rounds_ = 0;
};

}  // namespace gvd
