// The pieces of one face between its arcs, as polygons.
//
// A walk round a piece alternates between the face's boundary and its arcs: along a label interval to the next
// crossing, then along arcs with the piece on the left, turning at branch points, until an arc ends on the boundary
// again. Every label interval belongs to exactly one piece; a piece may have several intervals. The cell on the left
// determines with which arc the walk continues, because the cells round a crossing or a branch point differ.
// Invariant: the pieces of a face share no interior point and cover the face, because each side of each arc is walked
// once.
#include "diagram/graph/face_diagram.hpp"

#include <algorithm>
#include <compare>
#include <utility>

namespace gvd {
namespace {

/// Stands for the piece of an interval that has none yet.
constexpr int kNoPieceYet = -1;

/// Largest number of corners of a piece in a face with one straight arc or one branch point.
constexpr std::size_t kUsualCorners = 5;

/// The arcs of a face by their ends. Most faces have one arc, for which there is nothing to look up.
class ArcsByEnd {
 public:
  ArcsByEnd(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs)
      : boundary_(boundary), arcs_(arcs) {
    if (arcs.size() < 2) return;
    departures_.reserve(2 * arcs.size());
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      departures_.push_back({arcs[i].begin, arcs[i].left, i});
      departures_.push_back({arcs[i].end, arcs[i].right, i});
    }
    std::sort(departures_.begin(), departures_.end());
    for (std::size_t i = 0; i < boundary.size(); ++i) boundary_index_.emplace_back(boundary[i].id, i);
    std::sort(boundary_index_.begin(), boundary_index_.end());
  }

  /// The arc that leaves `here` with `own` on its left, other than `last`.
  const FaceArc& leaving(const ArcEnd& here, GeneratorId own, const FaceArc* last) const {
    if (arcs_.size() == 1) return arcs_[0];
    auto departure = std::lower_bound(departures_.begin(), departures_.end(), Departure{here, own, 0});
    while (&arcs_[departure->arc] == last) ++departure;
    return arcs_[departure->arc];
  }

  /// The index of a crossing on the boundary.
  std::size_t index_of(CrossingId id) const {
    if (arcs_.size() == 1) return boundary_[0].id == id ? 0 : 1;
    return std::lower_bound(boundary_index_.begin(), boundary_index_.end(), std::pair(id, std::size_t{0}))->second;
  }

 private:
  /// An arc as it is found from one of its ends by the cell on its left.
  struct Departure {
    ArcEnd from;
    GeneratorId left;
    std::size_t arc;
    auto operator<=>(const Departure&) const = default;
  };

  const std::vector<BoundaryCrossing>& boundary_;
  std::span<const FaceArc> arcs_;
  // Both ascending.
  std::vector<Departure> departures_;
  std::vector<std::pair<CrossingId, std::size_t>> boundary_index_;
};

/// Appends the corners of a piece along a label interval, from one crossing to the next.
void follow_interval(const BoundaryCrossing& from, const BoundaryCrossing& to, std::vector<Bary>& corners) {
  corners.push_back(from.bary());
  const bool wraps = to.corner < from.corner || (to.corner == from.corner && to.t <= from.t);
  const int last = to.corner + (wraps ? 3 : 0);
  for (int corner = from.corner + 1; corner <= last; ++corner) corners.push_back(bary_on_side(corner % 3, 0));
  corners.push_back(to.bary());
}

/// Appends the corners of a piece along the arcs through the face that begin at `from` with the piece on their left.
/// Returns the crossing where they end.
CrossingId follow_arcs(const BoundaryCrossing& from, const ArcsByEnd& arcs, const FaceDiagram& diagram,
                       std::vector<Bary>& corners) {
  ArcEnd here = at(from.id);
  const FaceArc* last = nullptr;
  while (true) {
    const FaceArc& arc = arcs.leaving(here, from.previous, last);
    const bool forwards = arc.begin == here;
    const auto inner = diagram.inner_points(arc);
    if (forwards) {
      corners.insert(corners.end(), inner.begin(), inner.end());
    } else {
      corners.insert(corners.end(), inner.rbegin(), inner.rend());
    }
    here = forwards ? arc.end : arc.begin;
    last = &arc;
    if (here.crossing.valid()) return here.crossing;
    corners.push_back(diagram.branches[here.branch].bary);
  }
}

}  // namespace

void trace_pieces(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs,
                  const FaceDiagram& diagram, WorkingPieces& result) {
  const ArcsByEnd arcs_by_end(boundary, arcs);
  result.pieces.clear();
  result.piece_of_interval.assign(boundary.size(), kNoPieceYet);
  for (std::size_t first = 0; first < boundary.size(); ++first) {
    if (result.piece_of_interval[first] != kNoPieceYet) continue;
    const auto number = static_cast<int>(result.pieces.size());
    std::vector<Bary>& corners = result.pieces.emplace_back(WorkingPiece{boundary[first].next, {}}).corners;
    corners.reserve(kUsualCorners + (arcs.size() == 1 ? arcs[0].point_count : 0));
    for (std::size_t interval = first; result.piece_of_interval[interval] == kNoPieceYet;) {
      result.piece_of_interval[interval] = number;
      const BoundaryCrossing& end = boundary[(interval + 1) % boundary.size()];
      follow_interval(boundary[interval], end, corners);
      interval = arcs_by_end.index_of(follow_arcs(end, arcs_by_end, diagram, corners));
    }
  }
}

}  // namespace gvd
