#pragma once

#include <cstddef>
#include <vector>

#include "base/barycentric.hpp"
#include "base/union_find.hpp"
#include "diagram/assembly/face_distances.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// A corner of the part of a face that remains to be assembled: a crossing, or a branch point that replaces two
/// corners.
struct PolygonCorner {
  ArcEnd end;
  Bary bary;
  GeneratorId next;  ///< generator of the label interval from here to the next corner
  int interval;  ///< index of that interval on the face's boundary, where it follows the crossing with the same index
};

/// A convex polygon in a face, counter-clockwise. Its corners separate the label intervals round it.
using FacePolygon = std::vector<PolygonCorner>;

/// How far a triangle's corner may lie on the wrong side of the opposite edge, in barycentric coordinates, if the
/// distances can confirm branch points. A branch point that a tie puts at a vertex lies kInsideFace from it, which is
/// as near as the crossings round the vertex, and on either side of them. The value is less than the 1e-11 from which a
/// piece counts as inverted.
inline constexpr double kTieInversion = 4.8e-12;

/// The midpoint of corner i and the next corner.
Bary midpoint(const FacePolygon& polygon, std::size_t i);
/// The mean of all corners.
Bary centre(const FacePolygon& polygon);

/// Whether a polygon of three corners or more is convex and counter-clockwise. Every three consecutive corners may be
/// inverted by up to `inversion`, in barycentric coordinates.
bool is_convex(const std::vector<Bary>& polygon, double inversion);

/// Whether p lies in the face and in the polygon, on its boundary, or up to `inversion` outside of it. Crossings of one
/// edge form a polygon without area. Then p must lie on that edge, and the pieces between such points have the area 0,
/// not a negative area.
bool is_inside(const FacePolygon& polygon, const Bary& p, double inversion);

/// Distance of two points in barycentric coordinates, computed from the last two coordinates.
double bary_distance(const Bary& p, const Bary& q);

/// The label intervals of a face's boundary, and which of them are known to belong to one piece of a cell. Interval i
/// lies between crossing i and the next one. The boundary must outlive this object.
class LabelIntervals {
 public:
  /// `boundary` must have at least two crossings.
  explicit LabelIntervals(const std::vector<BoundaryCrossing>& boundary)
      : boundary_(boundary), pieces_(boundary.size()) {}

  /// Unites two intervals of the same generator if the shortest path to the middle of one enters the face through the
  /// other. Stops at the first path that is unknown.
  void unite_by_paths(const FacePaths& paths);
  void unite(int interval, int other) { pieces_.unite(interval, other); }

  /// The number of an interval's piece: intervals that are known to belong to one piece have the same number.
  int piece(int interval) { return pieces_.find(interval); }
  bool are_one_piece(int interval, int other) { return piece(interval) == piece(other); }

  /// Whether the shortest path from the interval's generator to p enters the face through an interval of the same
  /// piece. A path within rounding of a crossing counts as entering through the intervals on both sides of the
  /// crossing.
  bool path_enters_through(int interval, const Bary& p, const FacePaths& paths);

 private:
  double position(int crossing) const { return boundary_[crossing].corner + boundary_[crossing].t; }
  int interval_at(double position) const;
  Bary middle_of_interval(int i) const;

  const std::vector<BoundaryCrossing>& boundary_;
  UnionFind pieces_;
};

/// Splits a polygon along every piece to which several of its intervals belong, because the two sides of such a piece
/// are assembled independently. Intervals next to each other do not split it.
/// Returns: the smaller polygons, which keep the order of the corners; none if there is nothing to split.
/// Cost: O(k log k) for k corners.
std::vector<FacePolygon> split_at_united_intervals(const FacePolygon& polygon, LabelIntervals& intervals);

}  // namespace gvd
