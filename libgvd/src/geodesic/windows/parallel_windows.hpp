#pragma once

#include <algorithm>
#include <cmath>

#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "geodesic/windows/window_geometry.hpp"

namespace gvd {

// Windows whose paths come from a straight segment of a curve, at right angles to it. The paths are parallel, and
// distances grow linearly along an edge. Whatever window_geometry.hpp and window_filters.hpp say about an image holds
// here for the segment, with the direction of the paths in place of the ray from the image, because the proofs there
// only use that paths are straight and that no path is shorter.
//
// Why a direction and not an image far away: an image at the distance D makes an arc of the straight front. Over a
// window of the width w, the arc is off by w^2 / (8 D). Sums of D and a length lose D / 2^52. Both together are never
// below 1e-8 w. The direction is rotated by the angle of a corner for each face, as an image is, so that its error
// grows in the same way (kSameImage). Nothing is divided by a length that may vanish.
//
// Parallel windows come only from a segment itself, because behind a vertex at which paths bend, windows have an image
// again. There are therefore few of them, and none of the code here belongs to the innermost loop.

/// The paths of a parallel window in its frame. At the point (x, y) their length is start + along x + across y, because
/// only the way in their direction makes them longer.
struct ParallelPaths {
  double along, across;  ///< unit vector of their direction, across > 0
  double start;          ///< distance of the frame's origin

  explicit ParallelPaths(const Window& w) : along(w.x), across(-w.depth), start(w.offset) {}
  double distance(double x, double y) const { return start + along * x + across * y; }
};

/// The window that a segment of a curve sends into the face of its halfedge.
inline Window window_from_segment(HalfedgeId h, double length, double start, GeneratorId g) {
  return {0, length, 0, -1, start, g, h};
}

/// Position of the apex relative to the outermost paths, as in ApexView.
struct ParallelApexView {
  double x, y;
  double beyond_begin, beyond_end;

  ParallelApexView(const Window& w, double apex_x, double apex_y)
      : x(apex_x),
        y(apex_y),
        beyond_begin(w.x * apex_y + (apex_x - w.begin) * w.depth),
        beyond_end(w.x * apex_y + (apex_x - w.end) * w.depth) {}

  bool all_right() const { return beyond_begin > 0; }
  bool all_left() const { return beyond_end < 0; }
  bool covered() const { return beyond_begin <= 0 && beyond_end >= 0; }

  /// Whether the apex, which is not covered, lies on the continuation of an outermost path; see is_grazed.
  bool is_grazed(const Window& w, double length) const {
    const double t = all_right() ? w.begin : w.end, beyond = all_right() ? beyond_begin : beyond_end;
    const double step_x = x - t, shift = kPositionRounding * length;
    return beyond * beyond <= kGrazingAngle * kGrazingAngle * (step_x * step_x + y * y) + shift * shift &&
           w.x * step_x - w.depth * y > 0;
  }
};

/// Where a path through the point u of the edge meets a side. Both positions are distances from the corner that the
/// side shares with the edge; `along` is the component of the path's direction away from that corner. See SideView.
inline double hit_by_parallel(double u, double along, double across, const ExitSide& side) {
  return u * across / (across * side.cosine - along * side.sine);
}

/// The sub-windows that leave a face by its left and by its right side, like cross_left and cross_right. The new frame
/// begins at the side's first corner for the left side, so that `start` stays; at the apex for the right one. Its axes
/// are those of the old frame, turned by the angle at the corner that the side shares with the edge.
inline Window cross_left_parallel(const Window& w, const ExitSide& side, const ParallelApexView& apex) {
  const ParallelPaths p(w);
  const double end =
      apex.all_left() ? std::min(side.length, hit_by_parallel(w.end, p.along, p.across, side)) : side.length;
  return {std::max(0.0, hit_by_parallel(w.begin, p.along, p.across, side)),
          end,
          p.along * side.cosine + p.across * side.sine,
          p.along * side.sine - p.across * side.cosine,
          p.start,
          w.generator,
          side.twin};
}
inline Window cross_right_parallel(const Window& w, double base, const ExitSide& side, const ParallelApexView& apex) {
  const ParallelPaths p(w);
  const auto from_apex = [&](double t) { return side.length - hit_by_parallel(base - t, -p.along, p.across, side); };
  return {apex.all_right() ? std::max(0.0, from_apex(w.begin)) : 0,
          std::min(side.length, from_apex(w.end)),
          p.along * side.cosine - p.across * side.sine,
          -p.along * side.sine - p.across * side.cosine,
          p.distance(apex.x, apex.y),
          w.generator,
          side.twin};
}

/// Whether a window has no width, its paths run along the edge, or the path through an end of the edge is shorter
/// everywhere on it; see is_beaten_by_start. The edge is `length` long.
inline bool is_parallel_dropped(const Window& w, double start_distance, double end_distance, double length) {
  const auto is_beaten = [](double through, double step, double own) {
    return through * (1 + kDropClearance) + step < own * (1 - kDropClearance);
  };
  return !(w.begin < w.end) || !(w.depth < 0) || is_beaten(start_distance, w.end, w.distance(w.end)) ||
         is_beaten(end_distance, length - w.begin, w.distance(w.begin));
}

}  // namespace gvd
