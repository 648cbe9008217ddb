#include "diagram/graph/boundary_loops.hpp"

#include <array>
#include <map>
#include <vector>

#include "base/union_find.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kNoPiece = -1;

/// Unites the sides of arcs and the label intervals of boundary edges that follow each other around a cell: every set
/// is a loop.
class LoopCounter {
 public:
  LoopCounter(const WorkingMesh& working, const TracedDiagram& traced)
      : mesh_(working.mesh()),
        traced_(traced),
        generators_(working.generator_vertices().size()),
        sets_(0),
        at_crossing_(traced.crossings.size(), {kNoPiece, kNoPiece}),
        at_branch_(traced.faces.branches.size()) {}

  IdVector<GeneratorId, std::int32_t> count() {
    for (const FaceArc& arc : traced_.faces.arcs) {
      add_side(arc, arc.left);
      add_side(arc, arc.right);
    }
    for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) {
      if (mesh_.is_boundary(EdgeId(i))) add_boundary_edge(EdgeId(i));
    }
    IdVector<GeneratorId, std::int32_t> loops(generators_, 0);
    for (std::size_t i = 0; i < label_.size(); ++i) {
      const auto member = static_cast<std::int32_t>(i);
      if (label_[i].valid() && sets_.find(member) == member) ++loops[label_[i]];
    }
    return loops;
  }

 private:
  std::int32_t add(GeneratorId g) {
    label_.push_back(g);
    return sets_.add();
  }

  // The cells at a crossing or at a branch point differ, so the end and the cell of a side determine what follows it.
  void add_side(const FaceArc& arc, GeneratorId g) {
    const std::int32_t side = add(g);
    for (const ArcEnd& end : {arc.begin, arc.end}) {
      if (end.crossing.valid()) {
        unite_at(end.crossing, g, side);
      } else {
        unite(at_branch_[end.branch].try_emplace(g, kNoPiece).first->second, side);
      }
    }
  }

  void add_boundary_edge(EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e);
    GeneratorId g = traced_.labels.label[mesh_.from(h)];
    std::int32_t interval = add(g);
    unite(at_vertex_.try_emplace(mesh_.from(h), kNoPiece).first->second, interval);
    for (std::int32_t k = 0; k < traced_.crossings.count(e); ++k) {
      const CrossingId id(traced_.crossings.first(e).value() + k);
      unite_at(id, g, interval);
      g = traced_.crossings[id].after;
      interval = add(g);
      unite_at(id, g, interval);
    }
    unite(at_vertex_.try_emplace(mesh_.to(h), kNoPiece).first->second, interval);
  }

  void unite_at(CrossingId id, GeneratorId g, std::int32_t member) {
    unite(at_crossing_[id][traced_.crossings[id].before == g ? 0 : 1], member);
  }

  void unite(std::int32_t& first, std::int32_t member) {
    if (first == kNoPiece) {
      first = member;
    } else {
      sets_.unite(first, member);
    }
  }

  const Mesh& mesh_;
  const TracedDiagram& traced_;
  std::size_t generators_;
  UnionFind sets_;
  std::vector<GeneratorId> label_;
  IdVector<CrossingId, std::array<std::int32_t, 2>> at_crossing_;
  IdVector<BranchPointId, std::map<GeneratorId, std::int32_t>> at_branch_;
  std::map<VertexId, std::int32_t> at_vertex_;
};

}  // namespace

IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced) {
  return LoopCounter(working, traced).count();
}

}  // namespace gvd
