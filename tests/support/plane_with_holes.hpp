#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/plane.hpp"
#include "gvd/vec.hpp"

namespace gvd::test {

/// Distances in a plane from which boxes are left out, by the visibility graph of the boxes' corners: shortest paths
/// are straight but for bends at corners. Shares nothing with the library's distances.
class PlaneWithHoles {
 public:
  PlaneWithHoles(std::vector<Box2> holes, std::vector<Vec2> sources)
      : holes_(std::move(holes)), ends_(std::move(sources)), distance_(ends_.size(), 0.0) {
    for (const Box2& hole : holes_) {
      for (const auto corner : {Box2::BottomLeft, Box2::BottomRight, Box2::TopLeft, Box2::TopRight}) {
        ends_.push_back(hole.corner(corner));
        distance_.push_back(kInfinity);
      }
    }
    for (std::size_t round = 0; round < ends_.size(); ++round) {
      for (std::size_t i = 0; i < ends_.size(); ++i) distance_[i] = std::min(distance_[i], distance(ends_[i]));
    }
  }

  double distance(const Vec2& p) const {
    double least = kInfinity;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const double d = distance_[i] + (p - ends_[i]).norm();
      if (d < least && is_visible(p, ends_[i])) least = d;
    }
    return least;
  }

 private:
  /// A segment that runs along a side of a hole, or touches a corner, is free.
  static constexpr double kInside = 1e-9;

  bool is_visible(const Vec2& a, const Vec2& b) const {
    return std::none_of(holes_.begin(), holes_.end(), [&](const Box2& hole) { return crosses(a, b, hole); });
  }
  static bool crosses(const Vec2& a, const Vec2& b, const Box2& hole) {
    double begin = 0, end = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double least = hole.min()[axis] + kInside - a[axis], most = hole.max()[axis] - kInside - a[axis];
      const double way = b[axis] - a[axis];
      if (way == 0 && (least >= 0 || most <= 0)) return false;
      if (way == 0) continue;
      begin = std::max(begin, std::min(least / way, most / way));
      end = std::min(end, std::max(least / way, most / way));
    }
    return begin < end;
  }

  std::vector<Box2> holes_;
  std::vector<Vec2> ends_;  // sources, then corners of holes
  std::vector<double> distance_;
};

}  // namespace gvd::test
