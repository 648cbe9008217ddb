// Traces the diagram of a window field that differs in some faces from a field that has been traced already.
//
// Idea: the crossings of an edge depend on the sources of its two faces, and the arcs of a face on its sources and on
// the crossings of its sides. Where these have not changed, crossings and arcs are copied, with the present ids of
// their elements; all others are computed. Both kinds are joined in the order of edges and faces.
// Source: none; tracing is that of trace_envelope.cpp. Cost: O(n) to find the changes, then the work of the edges and
// faces that changed.
// Invariant: crossings, arcs and branch points are those of the envelope tracer, in its order.
#include "diagram/envelope/retrace_envelope.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/sort_unique.hpp"

namespace gvd {
namespace {

/// Appends the arcs and branch points of faces of one diagram to another diagram. It is fastest if the faces ascend.
class FaceCopier {
 public:
  explicit FaceCopier(const FaceDiagram& from) : from_(from) {}

  /// Appends face f as face `to` of the result. `crossing(id)` returns the id of a crossing in the result.
  template <class CrossingOf>
  void append(FaceId f, FaceId to, CrossingOf crossing, FaceDiagram& result) {
    const std::int32_t shift =
        result.branches.count() - static_cast<std::int32_t>(seek(from_.branches.raw(), branch_, f));
    for (; branch_ < from_.branches.size() && from_.branches.raw()[branch_].face == f; ++branch_) {
      result.branches.push_back(from_.branches.raw()[branch_]);
      result.branches.raw().back().face = to;
    }
    for (seek(from_.arcs, arc_, f); arc_ < from_.arcs.size() && from_.arcs[arc_].face == f; ++arc_) {
      FaceArc arc = from_.arcs[arc_];
      const auto points = from_.inner_points(arc);
      arc.face = to;
      arc.first_point = static_cast<std::int32_t>(result.points.size());
      result.points.insert(result.points.end(), points.begin(), points.end());
      for (ArcEnd* end : {&arc.begin, &arc.end}) {
        if (end->branch.valid()) {
          end->branch = BranchPointId(end->branch.value() + shift);
        } else {
          end->crossing = crossing(end->crossing);
        }
      }
      result.arcs.push_back(arc);
    }
  }

 private:
  /// The first item that is not before face f. The position after the last item found is tried first.
  template <class Items>
  static std::size_t seek(const Items& items, std::size_t& at, FaceId f) {
    const bool is_next = (at == 0 || items[at - 1].face < f) && (at == items.size() || !(items[at].face < f));
    using Item = typename Items::value_type;
    if (!is_next) at = static_cast<std::size_t>(std::ranges::lower_bound(items, f, {}, &Item::face) - items.begin());
    return at;
  }

  const FaceDiagram& from_;
  std::size_t arc_ = 0, branch_ = 0;
};

}  // namespace

/// Whether the crossings of the edge of h are the same as before the change.
bool RetracingTracer::is_known(HalfedgeId h) const {
  const HalfedgeId twin = mesh_.twin(h);
  if (known_.is_changed[Mesh::face(h)] != 0) return false;
  return !twin.valid() || known_.is_changed[Mesh::face(twin)] == 0;
}

/// Whether the ends of an edge have different labels, or a window on halfedge h has a label other than theirs.
bool RetracingTracer::is_contested(HalfedgeId h, const NearestLabels& labels) const {
  const GeneratorId label = labels.label[mesh_.from(h)];
  bool contested = label != labels.label[mesh_.to(h)];
  field_.windows.for_each(h, [&](const Window& w) { contested |= w.generator != label; });
  return contested;
}

/// Computes the crossings of the edges at changed faces, and adds the known crossings of all other edges.
Crossings RetracingTracer::cross_edges(const NearestLabels& labels) const {
  std::vector<EdgeId> edges;
  for (const FaceId f : mesh_.faces()) {
    if (known_.is_changed[f] == 0) continue;
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const HalfedgeId twin = mesh_.twin(h);
      if (is_contested(h, labels) || (twin.valid() && is_contested(twin, labels))) edges.push_back(mesh_.edge(h));
    }
  }
  sort_unique(edges);
  std::vector<Crossing> crossings = tracer_.cross(edges, labels);
  for (Crossing crossing : known_.traced.first_crossings().items()) {
    const HalfedgeId old = known_.mesh.halfedge(crossing.edge);
    const FaceId f = known_.common.after[Mesh::face(old)];
    if (!f.valid()) continue;
    const HalfedgeId h = Mesh::halfedge(f, Mesh::corner(old));
    if (!is_known(h)) continue;
    crossing.edge = mesh_.edge(h);
    crossings.push_back(crossing);
  }
  std::ranges::sort(crossings, {}, [](const Crossing& c) { return std::pair(c.edge, c.t); });
  return {mesh_.edge_count(), std::move(crossings)};
}

/// Whether face f has the same sources and the same crossings as before the change.
bool RetracingTracer::has_known_crossings(FaceId f, const Crossings& crossings, std::vector<BoundaryCrossing>& now,
                                          std::vector<BoundaryCrossing>& before) const {
  if (known_.is_changed[f] != 0) return false;
  boundary_crossings(mesh_, crossings, f, now);
  boundary_crossings(known_.mesh, known_.traced.crossings, known_.common.before[f], before);
  return std::ranges::equal(now, before, [](const BoundaryCrossing& a, const BoundaryCrossing& b) {
    return a.corner == b.corner && a.t == b.t && a.previous == b.previous && a.next == b.next;
  });
}

/// Assembles the faces whose sources or crossings have changed, and copies the known arcs of all other faces.
void RetracingTracer::close_faces(TracedDiagram& traced) {
  const TracedDiagram& before = known_.traced;
  const auto counts = count_by_face(mesh_, traced.crossings);
  const std::vector<FaceId> faces = crossed_faces(counts);
  std::vector<BoundaryCrossing> now, past;  // of the current face
  std::vector<FaceId> changed;
  kept_.assign(mesh_.face_count(), 0);
  for (const FaceId f : faces) {
    kept_[f] = has_known_crossings(f, traced.crossings, now, past) ? 1 : 0;
    if (kept_[f] == 0) changed.push_back(f);
  }
  AssembledFaces assembled = tracer_.assemble(changed, counts, traced.crossings);
  traced.straightened = std::move(assembled.straightened);
  FaceCopier from_assembled(assembled.diagram), from_before(before.faces);
  for (const FaceId f : faces) {
    if (kept_[f] == 0) {
      const auto same = [](CrossingId id) { return id; };
      from_assembled.append(f, f, same, traced.faces);
      continue;
    }
    const FaceId old = known_.common.before[f];
    boundary_crossings(known_.mesh, before.crossings, old, past);
    boundary_crossings(mesh_, traced.crossings, f, now);
    const auto crossing = [&](CrossingId id) {
      return now[static_cast<std::size_t>(std::ranges::find(past, id, &BoundaryCrossing::id) - past.begin())].id;
    };
    from_before.append(old, f, crossing, traced.faces);
  }
  for (const StraightenedFace& s : before.straightened) {
    const FaceId f = known_.common.after[s.face];
    if (f.valid() && kept_[f] != 0) traced.straightened.push_back({f, s.error});
  }
  std::ranges::sort(traced.straightened, {}, &StraightenedFace::face);
}

}  // namespace gvd
