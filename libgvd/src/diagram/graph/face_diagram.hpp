#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/graph/crossings.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// An end of an arc: a crossing on the face's boundary, or a branch point inside the face.
struct ArcEnd {
  CrossingId crossing;
  BranchPointId branch;
  auto operator<=>(const ArcEnd&) const = default;
};

inline ArcEnd at(CrossingId c) { return {c, BranchPointId()}; }
inline ArcEnd at(BranchPointId b) { return {CrossingId(), b}; }

/// The part of a bisector inside one face: a polyline from end to end.
struct FaceArc {
  FaceId face;
  ArcEnd begin, end;
  GeneratorId left, right;                        ///< the cells on the two sides, on the way from begin to end
  std::int32_t first_point = 0, point_count = 0;  ///< the range of its inner points in FaceDiagram::points

  bool ends_at(const ArcEnd& e) const { return begin == e || end == e; }
  /// The cells on the way from one of its ends to the other.
  GeneratorId left_from(const ArcEnd& e) const { return begin == e ? left : right; }
  GeneratorId right_from(const ArcEnd& e) const { return begin == e ? right : left; }
};

/// A branch point of the working mesh.
struct FaceBranch {
  FaceId face;
  Bary bary;
  double distance = 0;  ///< mean distance to its generators, mesh units
};

/// The bisectors inside the faces. Together with the crossings it determines the diagram.
/// Properties: (1) arcs are ascending by face; (2) every crossing ends exactly one arc in each of its faces; (3) every
/// branch point ends at least three arcs; (4) within a face no two arcs cross.
struct FaceDiagram {
  std::vector<FaceArc> arcs;
  IdVector<BranchPointId, FaceBranch> branches;
  std::vector<Bary> points;  ///< inner points of refined arcs, barycentric in their face

  std::span<const Bary> inner_points(const FaceArc& arc) const {
    return {points.data() + arc.first_point, points.data() + arc.first_point + arc.point_count};
  }

  /// Appends the diagram of other faces, which must all come after the faces of this one.
  void append(const FaceDiagram& other) {
    const auto first_point = static_cast<std::int32_t>(points.size());
    const std::int32_t first_branch = branches.count();
    for (FaceArc arc : other.arcs) {
      arc.first_point += first_point;
      for (ArcEnd* end : {&arc.begin, &arc.end}) {
        if (end->branch.valid()) end->branch = BranchPointId(end->branch.value() + first_branch);
      }
      arcs.push_back(arc);
    }
    branches.raw().insert(branches.end(), other.branches.begin(), other.branches.end());
    points.insert(points.end(), other.points.begin(), other.points.end());
  }
};

/// A connected part of a face between its arcs.
struct WorkingPiece {
  GeneratorId generator;
  std::vector<Bary> corners;  ///< barycentric in the working face, counter-clockwise
};

/// All pieces of one face.
struct WorkingPieces {
  std::vector<WorkingPiece> pieces;
  /// For each label interval of the face's boundary, the piece along it. Interval i follows boundary crossing i.
  std::vector<int> piece_of_interval;
};

/// Traces the pieces of a face with these boundary crossings (at least 2). `arcs` are all arcs of the face in
/// `diagram`. `result` is overwritten; loops over faces reuse it to save allocations.
/// Cost: O(k log k) for k crossings and arcs, and the number of their points.
void trace_pieces(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs,
                  const FaceDiagram& diagram, WorkingPieces& result);

}  // namespace gvd
