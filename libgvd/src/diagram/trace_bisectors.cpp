// The last stop of an arc: from arcs inside faces to bisectors from branch point to branch point.
//
// Every crossing ends one arc in each of its faces, and every branch point ends the arcs of its ring. So a bisector is
// a chain: it begins at a branch point or on the mesh's boundary, and goes on at each crossing with the other arc
// there. Arcs that remain belong to closed bisectors. The chains are found first, by one thread; several threads then
// compute their points, in the faces of the input mesh, and the lengths are added in the order of the bisectors.
//
// Source: the paper's bisectors grow as wholes (section 4.3); here they follow from the arcs of any tracer.
// Invariant: every arc belongs to exactly one bisector, and the cell on its left is one and the same all along it. Ends
// that nothing continues, inside the mesh, are counted: a sound diagram has none.
#include <algorithm>
#include <array>

#include "diagram/bisector_length.hpp"
#include "diagram/finish_diagram.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kNoMember = -1;

/// Arcs of the bisectors in a chunk.
constexpr std::size_t kChunkArcs = 512;

/// The arcs of a bisector, from one of its ends to the other.
struct ArcChain {
  struct Step {
    std::int32_t arc;
    bool forwards;
  };
  ArcEnd from;
  std::vector<Step> steps;
};

class BisectorTracer {
 public:
  BisectorTracer(const WorkingMesh& working, const TracedDiagram& traced, Diagram& diagram)
      : working_(working), traced_(traced), arcs_(traced.faces.arcs), diagram_(diagram), visited_(arcs_.size(), false) {
    link_arcs();
  }

  void trace(const ParallelChunks& parallel) {
    add_branch_points();
    find_chains();
    const auto chunks = cut_by_work(chains_.size(), kChunkArcs, [&](std::size_t i) { return chains_[i].steps.size(); });
    const auto lengths = parallel.collect(chunks, steps::kPolylines, [&](const Chunk& chunk) {
      std::vector<double> of_chunk;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) of_chunk.push_back(build_polyline(i));
      return of_chunk;
    });
    for (const double length : lengths) diagram_.length += length;
  }

 private:
  void link_arcs() {
    crossing_arcs_.assign(traced_.crossings.size(), {kNoMember, kNoMember});
    branch_arcs_.resize(traced_.faces.branches.size());
    for (std::int32_t arc = 0; arc < std::ssize(arcs_); ++arc) {
      for (const ArcEnd& end : {arcs_[arc].begin, arcs_[arc].end}) {
        if (end.crossing.valid()) {
          auto& slots = crossing_arcs_[end.crossing];
          slots[slots[0] == kNoMember ? 0 : 1] = arc;
        } else {
          branch_arcs_[end.branch].push_back(arc);
        }
      }
    }
    for (const BranchPointId b : branch_arcs_.ids()) order_ring(b);
  }

  /// Sorts the arcs at a branch point counter-clockwise: the cell on the left of one is on the right of the next.
  void order_ring(BranchPointId b) {
    auto& ring = branch_arcs_[b];
    if (ring.empty()) return;
    for (auto next = ring.begin() + 1; next != ring.end(); ++next) {
      const GeneratorId left = arcs_[*(next - 1)].left_from(at(b));
      const auto found =
          std::find_if(next, ring.end(), [&](std::int32_t arc) { return arcs_[arc].right_from(at(b)) == left; });
      if (found != ring.end()) std::iter_swap(next, found);
    }
  }

  void add_branch_points() {
    for (const BranchPointId b : traced_.faces.branches.ids()) {
      const FaceBranch& branch = traced_.faces.branches[b];
      BranchPoint out;
      out.point = input_point(branch.face, branch.bary);
      out.position = position(working_.input(), out.point);
      for (const std::int32_t arc : branch_arcs_[b]) out.generators.push_back(arcs_[arc].right_from(at(b)));
      out.distance = branch.distance;
      diagram_.branch_points.push_back(std::move(out));
    }
  }

  SurfacePoint input_point(FaceId f, const std::array<double, 3>& bary) const {
    return make_surface_point(working_.parent(f), working_.parent_bary(f, bary));
  }

  SurfacePoint point(const ArcEnd& end) const {
    if (end.branch.valid()) return diagram_.branch_points[end.branch].point;
    const Crossing& crossing = traced_.crossings[end.crossing];
    const SurfacePoint p = edge_point(working_.mesh().halfedge(crossing.edge), crossing.t);
    return input_point(p.face, p.bary);
  }

  void find_chains() {
    for (const BranchPointId branch : branch_arcs_.ids()) {
      for (const std::int32_t arc : branch_arcs_[branch]) follow(arc, at(branch), false);
    }
    for (const CrossingId crossing : crossing_arcs_.ids()) {
      const auto [arc, other] = crossing_arcs_[crossing];
      if (arc != kNoMember && other == kNoMember) follow(arc, at(crossing), false);
    }
    // The remaining arcs have no end: their bisectors are closed.
    for (std::int32_t arc = 0; arc < std::ssize(arcs_); ++arc) follow(arc, arcs_[arc].begin, true);
  }

  /// Adds the bisector that begins with `arc` at `from`, if that arc is new: it ends at a branch point, at the mesh's
  /// boundary, or where it began. An end at a crossing where no further arc begins is unresolved.
  void follow(std::int32_t arc, const ArcEnd& from, bool closed) {
    if (visited_[arc]) return;
    Bisector bisector;
    bisector.left = arcs_[arc].left_from(from);
    bisector.right = arcs_[arc].right_from(from);
    bisector.closed = closed;
    if (!closed) bisector.ends[0] = from.branch;
    ArcChain& chain = chains_.emplace_back(ArcChain{from, {}});
    ArcEnd here = from;
    while (arc != kNoMember && !visited_[arc]) {
      visited_[arc] = true;
      const FaceArc& a = arcs_[arc];
      const bool forwards = a.begin == here;
      chain.steps.push_back({arc, forwards});
      here = forwards ? a.end : a.begin;
      if (here.branch.valid()) break;
      const auto& [first, second] = crossing_arcs_[here.crossing];
      arc = first == arc ? second : first;
    }
    bisector.ends[1] = here.branch;
    if (!closed) diagram_.report.unresolved_ends += is_unresolved(from) + is_unresolved(here);
    diagram_.bisectors.push_back(std::move(bisector));
  }

  bool is_unresolved(const ArcEnd& end) const {
    return !end.branch.valid() && !working_.mesh().is_boundary(traced_.crossings[end.crossing].edge);
  }

  /// Sets the points of bisector i; returns its length.
  double build_polyline(std::size_t i) {
    Bisector& bisector = diagram_.bisectors[BisectorId(i)];
    if (!bisector.closed) bisector.points.push_back(point(chains_[i].from));
    for (const ArcChain::Step& step : chains_[i].steps) {
      const FaceArc& arc = arcs_[step.arc];
      add_inner_points(arc, step.forwards, bisector.points);
      bisector.points.push_back(point(step.forwards ? arc.end : arc.begin));
    }
    return compute_length(working_.input(), bisector);
  }

  void add_inner_points(const FaceArc& arc, bool forwards, std::vector<SurfacePoint>& points) const {
    const auto inner = traced_.faces.inner_points(arc);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      points.push_back(input_point(arc.face, inner[forwards ? i : inner.size() - 1 - i]));
    }
  }

  const WorkingMesh& working_;
  const TracedDiagram& traced_;
  const std::vector<FaceArc>& arcs_;
  Diagram& diagram_;
  std::vector<bool> visited_;
  IdVector<CrossingId, std::array<std::int32_t, 2>> crossing_arcs_;
  IdVector<BranchPointId, std::vector<std::int32_t>> branch_arcs_;
  std::vector<ArcChain> chains_;  // one for each bisector
};

}  // namespace

void trace_bisectors(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                     Diagram& diagram) {
  BisectorTracer(working, traced, diagram).trace(parallel);
}

}  // namespace gvd
