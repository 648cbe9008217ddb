#include "diagram/graph/face_pieces.hpp"

#include <algorithm>

#include "base/barycentric.hpp"

namespace gvd {
namespace {

constexpr int kNone = -1;

/// A face cut once or round one branch point has pieces of at most this many corners.
constexpr std::size_t kUsualCorners = 5;

class PieceTracer {
 public:
  PieceTracer(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs, const FaceDiagram& diagram,
              WorkingPieces& result)
      : boundary_(boundary), arcs_(arcs), diagram_(diagram), result_(result) {}

  void trace() {
    result_.pieces.clear();
    result_.piece_of_interval.assign(boundary_.size(), kNone);
    for (std::size_t run = 0; run < boundary_.size(); ++run) {
      if (result_.piece_of_interval[run] == kNone) trace_from(run);
    }
  }

 private:
  /// Walks along run `first`, then with the piece on the left along arcs to the next run, until it is back.
  void trace_from(std::size_t first) {
    const auto number = static_cast<int>(result_.pieces.size());
    std::vector<Bary>& corners = result_.pieces.emplace_back(WorkingPiece{boundary_[first].next, {}}).corners;
    corners.reserve(kUsualCorners);
    for (std::size_t run = first; result_.piece_of_interval[run] == kNone;) {
      result_.piece_of_interval[run] = number;
      follow_run(run, corners);
      run = follow_arcs((run + 1) % boundary_.size(), corners);
    }
  }

  void follow_run(std::size_t run, std::vector<Bary>& corners) const {
    const BoundaryCrossing &from = boundary_[run], &to = boundary_[(run + 1) % boundary_.size()];
    corners.push_back(from.bary());
    const bool wraps = to.corner < from.corner || (to.corner == from.corner && to.t <= from.t);
    const int last = to.corner + (wraps ? 3 : 0);
    for (int corner = from.corner + 1; corner <= last; ++corner) {
      Bary bary{0, 0, 0};
      bary[static_cast<std::size_t>(corner % 3)] = 1;
      corners.push_back(bary);
    }
  }

  /// From boundary crossing i into the face, keeping to the left, until the boundary is met again: returns the
  /// crossing.
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

  /// The arc that leaves `here` with `own` on its left, other than the one we came by.
  const FaceArc& leaving(const ArcEnd& here, GeneratorId own, const FaceArc* came_by) const {
    const FaceArc* found = nullptr;
    for (const FaceArc& arc : arcs_) {
      if (&arc == came_by) continue;
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
