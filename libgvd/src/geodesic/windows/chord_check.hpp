#pragma once

#include <algorithm>
#include <vector>

#include "base/plane.hpp"
#include "geodesic/distance_field.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Whether the distance stays between two limits on a chord, a straight piece inside a face. The answer is exact up to
/// rounding: between the limits are all points of a chord that passes. One object serves one chord after the other.
class ChordCheck {
 public:
  /// Starts a chord. `least` and `most`: the limits, mesh units.
  void begin(const PlaneSegment& chord, double least, double most);
  /// Adds a source whose paths may be the shortest. False if one is shorter than `least`. Cost: O(1).
  bool add(const FaceSource& s);
  /// Whether each point has a path of at most `most`. `seam`: a gap that is no more than rounding, mesh units.
  /// Cost: O(k log k) for k sources.
  bool is_covered(double seam);

 private:
  /// A part of the chord, whose ends have the positions 0 and 1; begin > end if it is empty.
  struct Part {
    double begin = 0, end = 1;

    /// Keeps the part where value + slope t >= 0.
    void clip(double value, double slope) {
      if (slope > 0) {
        begin = std::max(begin, -value / slope);
      } else if (slope < 0) {
        end = std::min(end, value / -slope);
      } else if (value < 0) {
        end = -1;
      }
    }
  };

  bool add_paths_from(const Vec2& point, double offset, Part part);
  bool add_parallel_paths(const FaceSource& s, Part part);

  PlaneSegment chord_{};
  Vec2 way_ = Vec2::Zero();  // from the one end to the other
  double square_ = 0;        // of its length
  double least_ = 0, most_ = 0;
  std::vector<Part> parts_;  // that have a path of at most `most_`
};

}  // namespace gvd
