// Joins the arcs inside faces to bisectors from branch point to branch point.
//
// At every crossing, one arc in each of its faces ends, and at every branch point, the arcs of its ring end. A bisector
// is therefore a chain: it begins at a branch point or on the mesh's boundary, and continues at each crossing with the
// other arc there. Arcs that remain belong to closed bisectors. The chains are found first, by one thread; several
// threads then compute their points, in the faces of the input mesh, and the lengths are added in the order of the
// bisectors.
//
// Source: the paper's bisectors grow as wholes (section 4.3); here they follow from the arcs of any tracer.
// Invariant: every arc belongs to exactly one bisector, and the cell on a bisector's left is the same all along it.
// Ends inside the mesh that no arc continues are counted; a valid diagram has none.
#include "diagram/trace_bisectors.hpp"

#include <algorithm>
#include <array>

#include "diagram/bisector_length.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kNoArc = -1;

/// Number of arcs of the bisectors in a chunk.
constexpr std::size_t kChunkArcs = 512;

/// The arcs that end at each crossing, at most two, and at each branch point, counter-clockwise.
struct ArcLinks {
  IdVector<CrossingId, std::array<std::int32_t, 2>> at_crossing;
  IdVector<BranchPointId, std::vector<std::int32_t>> at_branch;
};

/// Sorts the arcs at a branch point counter-clockwise: the cell on the left of one is on the right of the next.
void order_ring(const std::vector<FaceArc>& arcs, BranchPointId b, std::vector<std::int32_t>& ring) {
  if (ring.empty()) return;
  for (auto next = ring.begin() + 1; next != ring.end(); ++next) {
    const GeneratorId left = arcs[*(next - 1)].left_from(at(b));
    const auto found =
        std::find_if(next, ring.end(), [&](std::int32_t arc) { return arcs[arc].right_from(at(b)) == left; });
    if (found != ring.end()) std::iter_swap(next, found);
  }
}

ArcLinks link_arcs(const TracedDiagram& traced) {
  const std::vector<FaceArc>& arcs = traced.faces.arcs;
  ArcLinks links;
  links.at_crossing.assign(traced.crossings.size(), {kNoArc, kNoArc});
  links.at_branch.resize(traced.faces.branches.size());
  for (std::int32_t arc = 0; arc < std::ssize(arcs); ++arc) {
    for (const ArcEnd& end : {arcs[arc].begin, arcs[arc].end}) {
      if (end.crossing.valid()) {
        auto& slots = links.at_crossing[end.crossing];
        slots[slots[0] == kNoArc ? 0 : 1] = arc;
      } else {
        links.at_branch[end.branch].push_back(arc);
      }
    }
  }
  for (const BranchPointId b : links.at_branch.ids()) order_ring(arcs, b, links.at_branch[b]);
  return links;
}

/// The arcs of a bisector, from one of its ends to the other.
struct ArcChain {
  struct Step {
    std::int32_t arc;
    bool forwards;
  };
  ArcEnd from, to;
  bool closed;
  std::vector<Step> steps;
};

std::vector<ArcChain> find_chains(const std::vector<FaceArc>& arcs, const ArcLinks& links) {
  std::vector<ArcChain> chains;
  std::vector<bool> visited(arcs.size(), false);
  // Adds the chain that begins with `arc` at `from`, if that arc is new. The chain ends at a branch point, at a
  // crossing where no further arc begins, or where it began.
  const auto follow = [&](std::int32_t arc, const ArcEnd& from, bool closed) {
    if (visited[arc]) return;
    ArcChain& chain = chains.emplace_back(ArcChain{from, from, closed, {}});
    while (arc != kNoArc && !visited[arc]) {
      visited[arc] = true;
      const FaceArc& a = arcs[arc];
      const bool forwards = a.begin == chain.to;
      chain.steps.push_back({arc, forwards});
      chain.to = forwards ? a.end : a.begin;
      if (chain.to.branch.valid()) break;
      const auto& [first, second] = links.at_crossing[chain.to.crossing];
      arc = first == arc ? second : first;
    }
  };
  for (const BranchPointId b : links.at_branch.ids()) {
    for (const std::int32_t arc : links.at_branch[b]) follow(arc, at(b), false);
  }
  for (const CrossingId c : links.at_crossing.ids()) {
    const auto [arc, other] = links.at_crossing[c];
    if (arc != kNoArc && other == kNoArc) follow(arc, at(c), false);
  }
  // The remaining arcs have no end: their bisectors are closed.
  for (std::int32_t arc = 0; arc < std::ssize(arcs); ++arc) follow(arc, arcs[arc].begin, true);
  return chains;
}

/// A point of a face of the working mesh as a point of the input.
SurfacePoint input_point(const WorkingMesh& working, FaceId f, const Bary& bary) {
  return make_surface_point(working.parent(f), working.parent_bary(f, bary));
}

/// All points of a bisector, in the input's faces. For a closed bisector, the first point is not repeated.
std::vector<SurfacePoint> build_polyline(const WorkingMesh& working, const TracedDiagram& traced,
                                         const ArcChain& chain) {
  const auto point = [&](const ArcEnd& end) {
    if (end.branch.valid()) {
      const FaceBranch& branch = traced.faces.branches[end.branch];
      return input_point(working, branch.face, branch.bary);
    }
    const Crossing& crossing = traced.crossings[end.crossing];
    const SurfacePoint p = edge_point(working.mesh().halfedge(crossing.edge), crossing.t);
    return input_point(working, p.face, p.bary);
  };
  std::vector<SurfacePoint> points;
  if (!chain.closed) points.push_back(point(chain.from));
  for (const auto& [index, forwards] : chain.steps) {
    const FaceArc& arc = traced.faces.arcs[index];
    const auto inner = traced.faces.inner_points(arc);
    for (std::size_t k = 0; k < inner.size(); ++k) {
      points.push_back(input_point(working, arc.face, inner[forwards ? k : inner.size() - 1 - k]));
    }
    points.push_back(point(forwards ? arc.end : arc.begin));
  }
  return points;
}

}  // namespace

void trace_bisectors(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                     Diagram& diagram) {
  const Mesh& mesh = working.mesh();
  const std::vector<FaceArc>& arcs = traced.faces.arcs;
  const ArcLinks links = link_arcs(traced);
  for (const BranchPointId b : traced.faces.branches.ids()) {
    const FaceBranch& branch = traced.faces.branches[b];
    BranchPoint out;
    out.point = input_point(working, branch.face, branch.bary);
    out.position = position(working.input(), out.point);
    for (const std::int32_t arc : links.at_branch[b]) out.generators.push_back(arcs[arc].right_from(at(b)));
    out.distance = branch.distance;
    diagram.branch_points.push_back(std::move(out));
  }

  const std::vector<ArcChain> chains = find_chains(arcs, links);
  const auto is_unresolved = [&](const ArcEnd& end) {
    return !end.branch.valid() && !mesh.is_boundary(traced.crossings[end.crossing].edge);
  };
  for (const ArcChain& chain : chains) {
    const FaceArc& first = arcs[chain.steps.front().arc];
    Bisector bisector;
    bisector.left = first.left_from(chain.from);
    bisector.right = first.right_from(chain.from);
    bisector.closed = chain.closed;
    if (!chain.closed) {
      bisector.ends = {chain.from.branch, chain.to.branch};
      diagram.report.unresolved_ends += is_unresolved(chain.from) + is_unresolved(chain.to);
    }
    diagram.bisectors.push_back(std::move(bisector));
  }

  const auto chunks = cut_by_work(chains.size(), kChunkArcs, [&](std::size_t i) { return chains[i].steps.size(); });
  const auto lengths = parallel.collect(chunks, steps::kPolylines, [&](const Chunk& chunk) {
    std::vector<double> of_chunk;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      Bisector& bisector = diagram.bisectors[BisectorId(i)];
      bisector.points = build_polyline(working, traced, chains[i]);
      of_chunk.push_back(compute_length(working.input(), bisector));
    }
    return of_chunk;
  });
  for (const double length : lengths) diagram.length += length;
}

}  // namespace gvd
