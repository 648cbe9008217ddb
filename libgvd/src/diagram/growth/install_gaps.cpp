#include "diagram/growth/install_gaps.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace gvd {
namespace {

/// A crossing of the new diagram, with its origin: a crossing of the old diagram, or a node of a grown gap.
struct CrossingOrigin {
  Crossing crossing;
  CrossingId old;
  std::size_t gap = 0, node = 0;
};

class GapInstaller {
 public:
  GapInstaller(const Mesh& mesh, const std::vector<ClosedGap>& closed, TracedDiagram& traced)
      : mesh_(mesh), closed_(closed), traced_(traced) {}

  void install() {
    renumber(merge_crossings());
    for (std::size_t c = 0; c < closed_.size(); ++c) append(closed_[c].grown, ends_[c]);
  }

 private:
  /// The crossings that stay and those that grew, ascending by (edge, t).
  std::vector<CrossingOrigin> merge_crossings() const {
    std::vector<CrossingOrigin> all;
    const std::vector<char> inside = edges_inside();
    for (std::size_t i = 0; i < traced_.crossings.size(); ++i) {
      const CrossingId id(static_cast<std::int64_t>(i));
      const Crossing& c = traced_.crossings[id];
      if (!inside[c.edge.index()]) all.push_back({c, id});
    }
    for (std::size_t c = 0; c < closed_.size(); ++c) {
      const auto& nodes = closed_[c].grown.nodes;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].kind == GapNode::Kind::crossing) all.push_back({nodes[n].crossing, CrossingId(), c, n});
      }
    }
    std::sort(all.begin(), all.end(), [](const CrossingOrigin& a, const CrossingOrigin& b) {
      return std::tuple(a.crossing.edge, a.crossing.t) < std::tuple(b.crossing.edge, b.crossing.t);
    });
    return all;
  }

  /// Per edge: whether all its faces lie in one grown gap. Two gaps never have an edge in common.
  std::vector<char> edges_inside() const {
    std::vector<char> inside(static_cast<std::size_t>(mesh_.edge_count()), 0);
    for (const ClosedGap& c : closed_) {
      for (const FaceId f : c.gap.faces) {
        for (int corner = 0; corner < 3; ++corner) {
          const HalfedgeId h = Mesh::halfedge(f, corner), twin = mesh_.twin(h);
          if (!twin.valid() || c.gap.contains(Mesh::face(twin))) inside[mesh_.edge(h).index()] = 1;
        }
      }
    }
    return inside;
  }

  /// Gives the crossings their new ids, and so the nodes that are crossings.
  void renumber(const std::vector<CrossingOrigin>& all) {
    IdVector<CrossingId, CrossingId> renamed(traced_.crossings.size());
    for (const ClosedGap& c : closed_) ends_.emplace_back(c.grown.nodes.size());
    std::vector<Crossing> items;
    for (const CrossingOrigin& origin : all) {
      const CrossingId id(static_cast<std::int64_t>(items.size()));
      items.push_back(origin.crossing);
      if (origin.old.valid()) {
        renamed[origin.old] = id;
      } else {
        ends_[origin.gap][origin.node] = at(id);
      }
    }
    traced_.crossings = Crossings(mesh_.edge_count(), std::move(items));
    for (std::size_t c = 0; c < closed_.size(); ++c) {
      const auto& nodes = closed_[c].grown.nodes;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].kind == GapNode::Kind::rim) ends_[c][n] = at(renamed[nodes[n].rim]);
      }
    }
  }

  /// Appends the branch points, arcs and moved vertices of one gap. `ends` has an entry for each of its nodes.
  void append(const GrownGap& grown, std::vector<ArcEnd>& ends) {
    for (std::size_t n = 0; n < grown.nodes.size(); ++n) {
      const GapNode& node = grown.nodes[n];
      if (node.kind != GapNode::Kind::branch) continue;
      ends[n] = at(traced_.faces.branches.push_back({node.face, node.bary, node.distance}));
    }
    for (const GapArc& arc : grown.arcs) {
      traced_.faces.arcs.push_back({arc.face, ends[arc.begin], ends[arc.end], arc.left, arc.right});
    }
    for (const auto& [v, g] : grown.labels) {
      traced_.labels.label[v] = g;
      traced_.moved.push_back(v);
    }
  }

  const Mesh& mesh_;
  const std::vector<ClosedGap>& closed_;
  TracedDiagram& traced_;
  std::vector<std::vector<ArcEnd>> ends_;  // per gap and node
};

}  // namespace

void install_grown_gaps(const Mesh& mesh, const std::vector<ClosedGap>& closed, TracedDiagram& traced) {
  GapInstaller(mesh, closed, traced).install();
}

}  // namespace gvd
