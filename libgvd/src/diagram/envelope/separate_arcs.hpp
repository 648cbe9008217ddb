#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "base/box_tree.hpp"
#include "base/plane.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// A face in assembly: the crossings on its boundary, and its arcs, branch points and inner points, which are the last
/// ones in a diagram of many faces. This is a view, so that arcs can be changed through a constant OpenFace, too.
class OpenFace {
 public:
  /// Begins a face without arcs at the end of `diagram`. Both arguments must outlive this object; `boundary` may be
  /// filled later.
  OpenFace(FaceDiagram& diagram, const std::vector<BoundaryCrossing>& boundary)
      : diagram_(diagram),
        boundary_(boundary),
        first_arc_(diagram.arcs.size()),
        first_branch_(diagram.branches.size()),
        first_point_(diagram.points.size()) {}

  const FaceDiagram& diagram() const { return diagram_; }
  const std::vector<BoundaryCrossing>& boundary() const { return boundary_; }
  std::span<FaceArc> arcs() const { return std::span(diagram_.arcs).subspan(first_arc_); }
  std::span<Bary> inner_points(const FaceArc& arc) const {
    return std::span(diagram_.points).subspan(arc.first_point, arc.point_count);
  }
  /// Cost: O(k) for k crossings on the boundary.
  Bary position(const ArcEnd& end) const {
    if (end.branch.valid()) return diagram_.branches[end.branch].bary;
    return std::find_if(boundary_.begin(), boundary_.end(), [&](const auto& c) { return c.id == end.crossing; })
        ->bary();
  }

  /// The ids of the branch points are in [first_branch(), end_branch()).
  BranchPointId first_branch() const { return BranchPointId(first_branch_); }
  BranchPointId end_branch() const { return BranchPointId(diagram_.branches.size()); }

  /// Removes all arcs, branch points and inner points of the face.
  void clear() {
    diagram_.arcs.resize(first_arc_);
    diagram_.branches.resize(first_branch_);
    diagram_.points.resize(first_point_);
  }

 private:
  FaceDiagram& diagram_;
  const std::vector<BoundaryCrossing>& boundary_;
  std::size_t first_arc_, first_branch_, first_point_;
};

/// A straight piece of an arc, in any coordinates of its face.
struct ArcSegment {
  PlaneSegment line;
  std::int32_t arc;
};

/// Finds the arcs of a face that intersect. Using one object for many faces saves allocations.
class ArcIntersections {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;

  /// Finds the pairs of arcs, also of an arc with itself, two of whose segments may intersect elsewhere than at a
  /// common end. All other pairs are disjoint, except for segments of the same direction from a common end. `segments`
  /// has the arcs one after the other, each from its beginning to its end.
  /// Returns: ascending, each pair once; valid until the next call.
  /// Cost: O(n log n) for n segments if few of them are near each other.
  const std::vector<Pair>& find(const std::vector<ArcSegment>& segments);

 private:
  BoxTree boxes_;  // boxes of the segments
  std::vector<Pair> found_;
};

/// Erases the loops of a polyline in barycentric coordinates. At an intersection with itself, the polyline continues
/// along the last of its segments there. The ends stay. The result is a part of the polyline, and does not intersect
/// itself beyond rounding.
///
/// Loops occur where a bisector turns back sharply. Points that are found across a chord may then lie on either of its
/// two branches, and the polyline through them alternates between the branches.
/// Returns: false, and changes nothing, if there is no loop or there are more than 1000 points.
/// Cost: O(n^2) for n points for each round of erasing; usually there are one or two rounds.
bool erase_loops(std::vector<Bary>& polyline);

/// Keeps the arcs of a face from intersecting after their refinement. Using one object for many faces saves
/// allocations.
class ArcSeparator {
 public:
  /// Changes arcs until none intersects itself or another arc. In each step, the arc with the most intersections loses
  /// its loops, or all inner points if it has no loop. Straight arcs of an assembly don't intersect, so this ends.
  /// Returns whether an arc changed.
  /// Cost: O(n log n) for n segments if nothing intersects.
  bool separate(OpenFace& face);

  /// Whether straight arcs intersect, or a piece between the arcs is inverted, beyond rounding. The assembly's convex
  /// steps exclude this. With branch points that are used as they are, rounding can cause it where nearly everything is
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
