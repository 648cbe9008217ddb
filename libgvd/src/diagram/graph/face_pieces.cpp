#include "diagram/graph/face_pieces.hpp"

#include <algorithm>

#include "base/barycentric.hpp"

namespace gvd {
namespace {

constexpr int kNone = -1;

/// Most corners of a piece in a face with one arc or one branch point.
constexpr std::size_t kUsualCorners = 5;

class PieceTracer {
 public:
  PieceTracer(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs, const FaceDiagram& diagram,
              WorkingPieces& result)
      : boundary_(boundary), arcs_(arcs), diagram_(diagram), result_(result) {}

  void trace() {
    result_.pieces.clear();
    result_.piece_of_interval.assign(boundary_.size(), kNone);
    for (std::size_t interval = 0; interval < boundary_.size(); ++interval) {
      if (result_.piece_of_interval[interval] == kNone) trace_from(interval);
    }
  }

 private:
  /// Follows the boundary along interval `first`, then arcs with the piece on the left to the next interval, until it
  /// is back.
  void trace_from(std::size_t first) {
    const auto number = static_cast<int>(result_.pieces.size());
    std::vector<Bary>& corners = result_.pieces.emplace_back(WorkingPiece{boundary_[first].next, {}}).corners;
    corners.reserve(kUsualCorners);
    for (std::size_t interval = first; result_.piece_of_interval[interval] == kNone;) {
      result_.piece_of_interval[interval] = number;
      follow_interval(interval, corners);
      interval = follow_arcs((interval + 1) % boundary_.size(), corners);
    }
  }

  void follow_interval(std::size_t interval, std::vector<Bary>& corners) const {
    const BoundaryCrossing &from = boundary_[interval], &to = boundary_[(interval + 1) % boundary_.size()];
    corners.push_back(from.bary());
    const bool wraps = to.corner < from.corner || (to.corner == from.corner && to.t <= from.t);
    const int last = to.corner + (wraps ? 3 : 0);
    for (int corner = from.corner + 1; corner <= last; ++corner) {
      Bary bary{0, 0, 0};
      bary[static_cast<std::size_t>(corner % 3)] = 1;
      corners.push_back(bary);
    }
  }

  /// Follows arcs from boundary crossing i through the face, with the piece on the left, to the boundary. Returns the
  /// boundary crossing where they end.
  std::size_t follow_arcs(std::size_t i, std::vector<Bary>& corners) const {
    corners.push_back(boundary_[i].bary());
    ArcEnd here = at(boundary_[i].id);
    const GeneratorId own = boundary_[i].previous;
    const FaceArc* last = nullptr;
    while (true) {
      const FaceArc& arc = leaving(here, own, last);
      const bool forwards = arc.begin == here;
      const auto inner = diagram_.inner_points(arc);
      if (forwards) {
        corners.insert(corners.end(), inner.begin(), inner.end());
      } else {
        corners.insert(corners.end(), inner.rbegin(), inner.rend());
      }
      here = forwards ? arc.end : arc.begin;
      last = &arc;
      if (here.crossing.valid()) break;
      corners.push_back(diagram_.branches[here.branch].bary);
    }
    const auto arrived = std::find_if(boundary_.begin(), boundary_.end(),
                                      [&](const BoundaryCrossing& c) { return c.id == here.crossing; });
    return static_cast<std::size_t>(arrived - boundary_.begin());
  }

  /// The arc that leaves `here` with `own` on its left, other than `last`.
  const FaceArc& leaving(const ArcEnd& here, GeneratorId own, const FaceArc* last) const {
    const FaceArc* found = nullptr;
    for (const FaceArc& arc : arcs_) {
      if (&arc == last) continue;
      if ((arc.begin == here && arc.left == own) || (arc.end == here && arc.right == own)) found = &arc;
    }
    return *found;
  }

  const std::vector<BoundaryCrossing>& boundary_;
  std::span<const FaceArc> arcs_;
  const FaceDiagram& diagram_;
  WorkingPieces& result_;
};

}  // namespace

void trace_pieces(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs,
                  const FaceDiagram& diagram, WorkingPieces& result) {
  PieceTracer(boundary, arcs, diagram, result).trace();
}

}  // namespace gvd
