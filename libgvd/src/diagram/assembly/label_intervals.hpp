#pragma once

#include <array>
#include <vector>

#include "base/union_find.hpp"
#include "diagram/assembly/face_distances.hpp"
#include "diagram/graph/crossings.hpp"

namespace gvd {

/// The runs of labels round a face, run i from crossing i to the next one, and which of them are known to be one piece
/// of a cell. The boundary and the metric must outlive it.
class LabelIntervals {
 public:
  LabelIntervals(const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances)
      : boundary_(boundary), distances_(distances), pieces_(boundary.size()) {}

  /// Unites the runs of one generator that are known to be one piece: the shortest path to the middle of the one comes
  /// into the face through the other.
  void unite_by_paths();
  void unite(int run, int other) { pieces_.unite(run, other); }

  int piece(int run) { return pieces_.find(run); }
  bool are_one_piece(int run, int other) { return piece(run) == piece(other); }

  /// Whether the shortest path to p of run's generator comes into the face by that run, or by one of its piece.
  bool path_enters_through(int run, const std::array<double, 3>& p);

 private:
  double place(std::size_t crossing) const { return boundary_[crossing].corner + boundary_[crossing].t; }
  int run_at(double where) const;
  std::array<double, 3> middle_of_run(std::size_t i) const;
  bool is_near_crossing(double where, std::size_t i) const;

  const std::vector<BoundaryCrossing>& boundary_;
  const FaceDistances& distances_;
  UnionFind pieces_;
};

}  // namespace gvd
