#pragma once

#include <vector>

#include "base/barycentric.hpp"
#include "base/union_find.hpp"
#include "diagram/assembly/face_distances.hpp"
#include "diagram/graph/crossings.hpp"

namespace gvd {

/// The label intervals of a face's boundary, and which of them are known to belong to one piece of a cell. Interval i
/// lies between crossing i and the next one. The boundary and the distances must outlive this.
class LabelIntervals {
 public:
  /// `boundary`: at least two crossings.
  LabelIntervals(const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances)
      : boundary_(boundary), distances_(distances), pieces_(boundary.size()) {}

  /// Unites two intervals of one generator where the shortest path to the middle of the one enters the face through the
  /// other. Does nothing where the distances don't know the paths.
  void unite_by_paths();
  void unite(int interval, int other) { pieces_.unite(interval, other); }

  /// A number that all intervals known to belong to one piece share.
  int piece(int interval) { return pieces_.find(interval); }
  bool are_one_piece(int interval, int other) { return piece(interval) == piece(other); }

  /// Whether the shortest path to p of the interval's generator enters the face through an interval of its piece. A
  /// path within rounding of a crossing counts as one through the intervals on both sides of it.
  bool path_enters_through(int interval, const Bary& p);

 private:
  double position(std::size_t crossing) const { return boundary_[crossing].corner + boundary_[crossing].t; }
  int interval_at(double position) const;
  Bary middle_of_interval(std::size_t i) const;
  bool is_near_crossing(double position, std::size_t i) const;

  const std::vector<BoundaryCrossing>& boundary_;
  const FaceDistances& distances_;
  UnionFind pieces_;
};

}  // namespace gvd
