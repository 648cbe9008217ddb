#pragma once

#include <vector>

#include "diagram/envelope/arc_intersections.hpp"
#include "diagram/envelope/open_face.hpp"
#include "diagram/graph/face_pieces.hpp"

namespace gvd {

/// Keeps the arcs of a face from intersecting after their refinement. Using one object for many faces saves
/// allocations.
class ArcSeparator {
 public:
  /// Changes arcs until none intersects itself or another one: always the arc with the most intersections. It loses its
  /// loops, or all inner points if it has no loop. Straight arcs of an assembly don't intersect, so this ends.
  /// Returns whether an arc changed.
  /// Cost: O(n log n) for n segments where nothing intersects.
  bool separate(OpenFace& face);

  /// Whether straight arcs intersect, or a piece between the arcs is inverted, beyond rounding. The assembly's convex
  /// steps exclude this; rounding can cause it with branch points that are used as they are, where nearly everything is
  /// a tie.
  /// Cost: O(k^2) for k arcs.
  bool is_inverted(const OpenFace& face);

 private:
  FaceArc* most_intersecting(OpenFace& face);
  void collect_segments(const OpenFace& face);

  std::vector<ArcSegment> segments_;
  ArcIntersections intersections_;
  std::vector<PlaneSegment> straight_;
  WorkingPieces pieces_;
};

}  // namespace gvd
