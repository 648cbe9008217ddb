#pragma once

#include "base/plane.hpp"
#include "geodesic/field/distance_field.hpp"

namespace gvd {

/// The change of one generator's shortest path along a segment, from one source to another. There the distance has a
/// corner: it is the lesser one of two distances.
///
/// Both distances count as linear between two positions. Then they are equal where their differences divide the way.
class PathChange {
 public:
  /// No change.
  PathChange() = default;
  /// From the source that is the nearest at the segment's start, at this distance, to the one at its end.
  /// Both must outlive this.
  PathChange(const PlaneSegment& segment, const FaceSource& first, double at_start, const FaceSource& second,
             double at_end)
      : first_(&first),
        second_(&second),
        segment_(segment),
        before_{0, second.distance(segment.from) - at_start},
        after_{1, first.distance(segment.to) - at_end} {}

  /// How far the distance at the corner lies above the line through its values at the two ends, mesh units.
  double height() const {
    const double sum = before_.excess + after_.excess;
    return sum > 0 ? before_.excess * (after_.excess / sum) : 0;
  }

  /// The position of the corner, as a fraction of the segment: so near that no corner higher than `least` is left on
  /// either side of it, or after eight steps. Call it while `height` > 0. Cost: two paths a step.
  double find(double least) {
    for (int step = 0; step < kMostSteps && height() > least; ++step) {
      const double t = position();
      const Vec2 p = segment_.from + t * (segment_.to - segment_.from);
      const double excess = second_->distance(p) - first_->distance(p);
      if (excess > 0) {
        before_ = {t, excess};
      } else {
        after_ = {t, -excess};
      }
    }
    return position();
  }

 private:
  static constexpr int kMostSteps = 8;

  /// By how much the farther one of the two sources is farther at a position.
  struct Excess {
    double position = 0, excess = 0;
  };
  double position() const {
    const double sum = before_.excess + after_.excess;
    const double share = sum > 0 ? before_.excess / sum : 0.5;
    return before_.position + share * (after_.position - before_.position);
  }

  const FaceSource *first_ = nullptr, *second_ = nullptr;
  PlaneSegment segment_{};
  Excess before_, after_;
};

}  // namespace gvd
