#include <algorithm>

#include "diagram/diagram_graph.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kNone = -1;

class BisectorTracer {
 public:
  BisectorTracer(const WorkingMesh& working, const TracedDiagram& traced, Diagram& diagram)
      : working_(working), traced_(traced), arcs_(traced.faces.arcs), diagram_(diagram), visited_(arcs_.size(), false) {
    link_arcs();
  }

  void trace() {
    add_branch_points();
    for (std::size_t b = 0; b < branch_arcs_.size(); ++b) {
      const BranchPointId branch(static_cast<std::int64_t>(b));
      for (const std::int32_t arc : branch_arcs_[branch]) trace_open(arc, at(branch));
    }
    for (std::size_t c = 0; c < traced_.crossings.size(); ++c) {
      const CrossingId crossing(static_cast<std::int64_t>(c));
      if (working_.mesh().is_boundary(traced_.crossings[crossing].edge)) {
        trace_open(crossing_arcs_[crossing][0], at(crossing));
      }
    }
    for (std::size_t a = 0; a < arcs_.size(); ++a) trace_closed(static_cast<std::int32_t>(a));
  }

 private:
  void link_arcs() {
    crossing_arcs_.assign(traced_.crossings.size(), {kNone, kNone});
    branch_arcs_.resize(traced_.faces.branches.size());
    for (std::size_t a = 0; a < arcs_.size(); ++a) {
      for (const ArcEnd& end : {arcs_[a].begin, arcs_[a].end}) {
        const auto arc = static_cast<std::int32_t>(a);
        if (end.crossing.valid()) {
          auto& slots = crossing_arcs_[end.crossing];
          slots[slots[0] == kNone ? 0 : 1] = arc;
        } else {
          branch_arcs_[end.branch].push_back(arc);
        }
      }
    }
    for (std::size_t b = 0; b < branch_arcs_.size(); ++b) order_ring(BranchPointId(static_cast<std::int64_t>(b)));
  }

  GeneratorId left_when_leaving(std::int32_t arc, const ArcEnd& from) const {
    const FaceArc& a = arcs_[static_cast<std::size_t>(arc)];
    return a.begin == from ? a.left : a.right;
  }
  GeneratorId right_when_leaving(std::int32_t arc, const ArcEnd& from) const {
    const FaceArc& a = arcs_[static_cast<std::size_t>(arc)];
    return a.begin == from ? a.right : a.left;
  }

  /// Counter-clockwise: the cell on the left of one arc is on the right of the next.
  void order_ring(BranchPointId b) {
    auto& ring = branch_arcs_[b];
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const GeneratorId left = left_when_leaving(ring[i], at(b));
      const auto next = std::find_if(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, ring.end(),
                                     [&](std::int32_t arc) { return right_when_leaving(arc, at(b)) == left; });
      if (next != ring.end()) std::iter_swap(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, next);
    }
  }

  void add_branch_points() {
    for (std::size_t i = 0; i < traced_.faces.branches.size(); ++i) {
      const BranchPointId b(static_cast<std::int64_t>(i));
      const FaceBranch& branch = traced_.faces.branches[b];
      BranchPoint out;
      out.point = input_point(branch.face, branch.bary);
      out.position = position(working_.input(), out.point);
      for (const std::int32_t arc : branch_arcs_[b]) out.generators.push_back(right_when_leaving(arc, at(b)));
      out.distance = branch.distance;
      diagram_.branch_points.push_back(std::move(out));
    }
  }

  SurfacePoint input_point(FaceId f, const std::array<double, 3>& bary) const {
    return make_surface_point(working_.parent(f), working_.parent_bary(f, bary));
  }

  SurfacePoint point(const ArcEnd& end) const {
    if (end.branch.valid()) return diagram_.branch_points[end.branch].point;
    return crossing_point(working_, traced_.crossings[end.crossing]);
  }

  /// Follows arcs from `from` until a branch point, the mesh's boundary or the beginning; appends the bisector.
  void walk(std::int32_t arc, const ArcEnd& from, Bisector& bisector) {
    bisector.left = left_when_leaving(arc, from);
    bisector.right = right_when_leaving(arc, from);
    ArcEnd here = from;
    while (arc != kNone && !visited_[static_cast<std::size_t>(arc)]) {
      visited_[static_cast<std::size_t>(arc)] = true;
      const FaceArc& a = arcs_[static_cast<std::size_t>(arc)];
      add_inner_points(a, a.begin == here, bisector.points);
      here = a.begin == here ? a.end : a.begin;
      bisector.points.push_back(point(here));
      if (here.branch.valid()) break;
      const auto& [first, second] = crossing_arcs_[here.crossing];
      arc = first == arc ? second : first;
    }
    bisector.ends[1] = here.branch;
    add(bisector);
  }

  void add_inner_points(const FaceArc& arc, bool forwards, std::vector<SurfacePoint>& points) const {
    const auto inner = traced_.faces.inner_points(arc);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      points.push_back(input_point(arc.face, inner[forwards ? i : inner.size() - 1 - i]));
    }
  }

  void trace_open(std::int32_t arc, const ArcEnd& from) {
    if (visited_[static_cast<std::size_t>(arc)]) return;
    Bisector bisector;
    bisector.ends[0] = from.branch;
    bisector.points.push_back(point(from));
    walk(arc, from, bisector);
  }

  /// What is left has no end: it closes on itself.
  void trace_closed(std::int32_t arc) {
    if (visited_[static_cast<std::size_t>(arc)]) return;
    Bisector bisector;
    bisector.closed = true;
    walk(arc, arcs_[static_cast<std::size_t>(arc)].begin, bisector);
  }

  void add(Bisector& bisector) {
    const std::size_t n = bisector.points.size();
    for (std::size_t i = 0; i + (bisector.closed ? 0 : 1) < n; ++i) {
      diagram_.length +=
          (position(working_.input(), bisector.points[(i + 1) % n]) - position(working_.input(), bisector.points[i]))
              .norm();
    }
    diagram_.bisectors.push_back(std::move(bisector));
  }

  const WorkingMesh& working_;
  const TracedDiagram& traced_;
  const std::vector<FaceArc>& arcs_;
  Diagram& diagram_;
  std::vector<bool> visited_;
  IdVector<CrossingId, std::array<std::int32_t, 2>> crossing_arcs_;
  IdVector<BranchPointId, std::vector<std::int32_t>> branch_arcs_;
};

}  // namespace

SurfacePoint crossing_point(const WorkingMesh& working, const Crossing& crossing) {
  const SurfacePoint p = edge_point(working.mesh().halfedge(crossing.edge), crossing.t);
  return make_surface_point(working.parent(p.face), working.parent_bary(p.face, p.bary));
}

void trace_bisectors(const WorkingMesh& working, const TracedDiagram& traced, Diagram& diagram) {
  BisectorTracer(working, traced, diagram).trace();
}

}  // namespace gvd
