// The crossings of all edges as one sorted list, and the pieces of one face between its arcs, as polygons.
//
// A crossing is stored once, on its edge; both faces read it from there (BoundaryCrossing turns it round where the face
// runs through the edge backwards). So two faces can't disagree about a bisector, whatever the distances are. A tracer
// that crosses some edges again replaces their crossings all at once; ids of crossings change by this.
// The list costs 24 bytes a crossing and 4 bytes an edge; most edges have none. Replacing costs one pass over the list.
//
// A walk round a piece alternates between the face's boundary and its arcs: along a label interval to the next
// crossing, then along arcs with the piece on the left, turning at branch points, until an arc ends on the boundary
// again. Every label interval has exactly one piece; a piece may have several intervals. The cell on its left tells
// which arc goes on, because the cells round a crossing or a branch point differ.
// Invariant: the pieces of a face share no interior point and cover it, since each side of each arc is walked once.
#include "diagram/graph/face_diagram.hpp"

#include <algorithm>
#include <compare>
#include <iterator>
#include <utility>

#include "diagram/graph/crossings.hpp"

namespace gvd {
namespace {

constexpr int kNoInterval = -1;

/// Most corners of a piece in a face with one arc or one branch point.
constexpr std::size_t kUsualCorners = 5;

class PieceTracer {
 public:
  PieceTracer(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs, const FaceDiagram& diagram,
              WorkingPieces& result)
      : boundary_(boundary), arcs_(arcs), diagram_(diagram), result_(result) {}

  void trace() {
    if (arcs_.size() > 1) {
      index_arcs();
      index_crossings();
    }
    result_.pieces.clear();
    result_.piece_of_interval.assign(boundary_.size(), kNoInterval);
    for (std::size_t interval = 0; interval < boundary_.size(); ++interval) {
      if (result_.piece_of_interval[interval] == kNoInterval) trace_from(interval);
    }
  }

 private:
  /// An arc as it is found from one of its ends, by the cell on its left on the way from there.
  struct Departure {
    ArcEnd from;
    GeneratorId left;
    std::size_t arc;
    auto operator<=>(const Departure&) const = default;
  };

  void index_arcs() {
    departures_.reserve(2 * arcs_.size());
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      departures_.push_back({arcs_[i].begin, arcs_[i].left, i});
      departures_.push_back({arcs_[i].end, arcs_[i].right, i});
    }
    std::sort(departures_.begin(), departures_.end());
  }

  void index_crossings() {
    for (std::size_t i = 0; i < boundary_.size(); ++i) boundary_index_.emplace_back(boundary_[i].id, i);
    std::sort(boundary_index_.begin(), boundary_index_.end());
  }

  /// Follows the boundary along interval `first`, then arcs with the piece on the left to the next interval, until it
  /// is back.
  void trace_from(std::size_t first) {
    const auto number = static_cast<int>(result_.pieces.size());
    std::vector<Bary>& corners = result_.pieces.emplace_back(WorkingPiece{boundary_[first].next, {}}).corners;
    corners.reserve(kUsualCorners + (arcs_.size() == 1 ? arcs_[0].point_count : 0));
    for (std::size_t interval = first; result_.piece_of_interval[interval] == kNoInterval;) {
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
    for (int corner = from.corner + 1; corner <= last; ++corner) corners.push_back(bary_on_side(corner % 3, 0));
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
    return index_of(here.crossing);
  }

  std::size_t index_of(CrossingId id) const {
    if (arcs_.size() == 1) return boundary_[0].id == id ? 0 : 1;
    return std::lower_bound(boundary_index_.begin(), boundary_index_.end(), std::pair(id, std::size_t{0}))->second;
  }

  /// The arc that leaves `here` with `own` on its left, other than `last`.
  const FaceArc& leaving(const ArcEnd& here, GeneratorId own, const FaceArc* last) const {
    if (arcs_.size() == 1) return arcs_[0];
    auto departure = std::lower_bound(departures_.begin(), departures_.end(), Departure{here, own, 0});
    while (&arcs_[departure->arc] == last) ++departure;
    return arcs_[departure->arc];
  }

  const std::vector<BoundaryCrossing>& boundary_;
  std::span<const FaceArc> arcs_;
  const FaceDiagram& diagram_;
  WorkingPieces& result_;
  // Both ascending; empty in a face with one arc, as most are.
  std::vector<Departure> departures_;
  std::vector<std::pair<CrossingId, std::size_t>> boundary_index_;
};

}  // namespace

void Crossings::replace(const std::vector<EdgeId>& edges, const std::vector<Crossing>& replacements) {
  std::vector<Crossing> kept, all;
  std::copy_if(items().begin(), items().end(), std::back_inserter(kept),
               [&](const Crossing& c) { return !std::binary_search(edges.begin(), edges.end(), c.edge); });
  std::merge(kept.begin(), kept.end(), replacements.begin(), replacements.end(), std::back_inserter(all),
             [](const Crossing& a, const Crossing& b) { return a.edge < b.edge; });
  *this = Crossings(first_.count(), std::move(all));
}

IdVector<FaceId, std::int32_t> count_by_face(const Mesh& mesh, const Crossings& crossings) {
  IdVector<FaceId, std::int32_t> counts(mesh.face_count(), 0);
  for (const Crossing& c : crossings.items()) {
    const HalfedgeId h = mesh.halfedge(c.edge), twin = mesh.twin(h);
    ++counts[Mesh::face(h)];
    if (twin.valid()) ++counts[Mesh::face(twin)];
  }
  return counts;
}

std::vector<FaceId> crossed_faces(const IdVector<FaceId, std::int32_t>& counts) {
  std::vector<FaceId> faces;
  std::copy_if(counts.ids().begin(), counts.ids().end(), std::back_inserter(faces),
               [&](FaceId f) { return counts[f] > 0; });
  return faces;
}

std::vector<FaceId> crossed_faces(const Mesh& mesh, const Crossings& crossings) {
  return crossed_faces(count_by_face(mesh, crossings));
}

void trace_pieces(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs,
                  const FaceDiagram& diagram, WorkingPieces& result) {
  PieceTracer(boundary, arcs, diagram, result).trace();
}

}  // namespace gvd
