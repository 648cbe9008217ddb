#include "diagram/growth/check_growth.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "base/segment.hpp"
#include "diagram/growth/growing_end.hpp"
#include "geodesic/field/face_layout.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

class GrowthCheck {
 public:
  GrowthCheck(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
              GrownGap& grown)
      : working_(working), mesh_(working.mesh()), labels_(labels), crossings_(crossings), gap_(gap), grown_(grown) {}

  bool run() {
    collect_edges();
    return nodes_are_met() && edges_keep_gaps() && find_labels() && edges_agree() && branches_turn_left() &&
           arcs_stay_apart();
  }

 private:
  struct GapEdge {
    EdgeId edge;
    bool rim;                             // one of its faces lies outside of the gap
    std::span<const Crossing> crossings;  // ascending in t
  };

  /// Every edge of the gap with its crossings: those of the rim as they were, inside it those that grew.
  void collect_edges() {
    for (const FaceId f : gap_.faces) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId h = Mesh::halfedge(f, corner), twin = mesh_.twin(h);
        edges_.push_back({mesh_.edge(h), twin.valid() && !gap_.contains(Mesh::face(twin)), {}});
      }
    }
    std::sort(edges_.begin(), edges_.end(), [](const auto& a, const auto& b) { return a.edge < b.edge; });
    const auto same = [](const auto& a, const auto& b) { return a.edge == b.edge; };
    edges_.erase(std::unique(edges_.begin(), edges_.end(), same), edges_.end());
    for (const GapEdge& e : edges_) {
      for (std::int32_t k = 0; e.rim && k < crossings_.count(e.edge); ++k) {
        gap_crossings_.push_back(crossings_[CrossingId(crossings_.first(e.edge).value() + k)]);
      }
    }
    for (const GapNode& node : grown_.nodes) {
      if (node.kind == GapNode::Kind::crossing) gap_crossings_.push_back(node.crossing);
    }
    std::sort(gap_crossings_.begin(), gap_crossings_.end(),
              [](const auto& a, const auto& b) { return std::tuple(a.edge, a.t) < std::tuple(b.edge, b.t); });
    std::size_t next = 0;
    for (GapEdge& e : edges_) {
      const std::size_t first = next;
      while (next < gap_crossings_.size() && gap_crossings_[next].edge == e.edge) ++next;
      e.crossings = std::span(gap_crossings_).subspan(first, next - first);
    }
  }

  const Crossing& crossing_of(const GapNode& node) const {
    return node.kind == GapNode::Kind::rim ? crossings_[node.rim] : node.crossing;
  }

  /// Whether a node lies in the face of an arc that leaves it, or comes to it, between these cells.
  bool fits(const GapNode& node, FaceId f, GeneratorId left, GeneratorId right) const {
    if (!gap_.contains(f)) return false;
    if (node.kind == GapNode::Kind::branch)
      return node.face == f && *std::min_element(node.bary.begin(), node.bary.end()) >= 0;
    const Crossing& c = crossing_of(node);
    const HalfedgeId h = mesh_.halfedge(c.edge), twin = mesh_.twin(h);
    // Into its first halfedge's face, the edge's beginning lies on the left.
    if (Mesh::face(h) == f) return left == c.before && right == c.after;
    return twin.valid() && Mesh::face(twin) == f && left == c.after && right == c.before;
  }

  /// Every crossing of the rim is a node and ends one arc, every new one an arc in each of its faces, every branch
  /// point three.
  bool nodes_are_met() const {
    std::vector<std::vector<FaceId>> faces(grown_.nodes.size());
    for (const GapArc& arc : grown_.arcs) {
      const auto begin = static_cast<std::size_t>(arc.begin), end = static_cast<std::size_t>(arc.end);
      if (!fits(grown_.nodes[begin], arc.face, arc.left, arc.right)) return false;
      if (!fits(grown_.nodes[end], arc.face, arc.right, arc.left)) return false;
      faces[begin].push_back(arc.face);
      faces[end].push_back(arc.face);
    }
    std::size_t rim_nodes = 0, rim_crossings = 0;
    for (std::size_t n = 0; n < grown_.nodes.size(); ++n) {
      const GapNode& node = grown_.nodes[n];
      rim_nodes += node.kind == GapNode::Kind::rim ? 1 : 0;
      if (faces[n].size() != arc_count(node)) return false;
      if (node.kind == GapNode::Kind::crossing && faces[n].size() == 2 && faces[n][0] == faces[n][1]) return false;
    }
    for (const GapEdge& e : edges_) rim_crossings += e.rim ? e.crossings.size() : 0;
    return rim_nodes == rim_crossings && rim_nodes_differ();
  }

  bool rim_nodes_differ() const {
    std::vector<CrossingId> rim;
    for (const GapNode& node : grown_.nodes) {
      if (node.kind == GapNode::Kind::rim) rim.push_back(node.rim);
    }
    std::sort(rim.begin(), rim.end());
    return std::adjacent_find(rim.begin(), rim.end()) == rim.end();
  }

  std::size_t arc_count(const GapNode& node) const {
    if (node.kind == GapNode::Kind::branch) return 3;
    return node.kind == GapNode::Kind::rim || mesh_.is_boundary(node.crossing.edge) ? 1 : 2;
  }

  bool edges_keep_gaps() const {
    for (const GapEdge& e : edges_) {
      if (!e.crossings.empty() && (e.crossings.front().t < kCrossingGap || e.crossings.back().t > 1 - kCrossingGap)) {
        return false;
      }
      for (std::size_t i = 1; i < e.crossings.size(); ++i) {
        if (e.crossings[i].t - e.crossings[i - 1].t < kCrossingGap) return false;
        if (e.crossings[i].before != e.crossings[i - 1].after) return false;
      }
    }
    return true;
  }

  /// A vertex of the gap as an end of one of its edges.
  struct EdgeAtVertex {
    VertexId vertex;
    std::size_t edge;  // place in edges_
  };

  void collect_vertices() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const HalfedgeId h = mesh_.halfedge(edges_[i].edge);
      edges_of_.push_back({mesh_.from(h), i});
      edges_of_.push_back({mesh_.to(h), i});
    }
    std::sort(edges_of_.begin(), edges_of_.end(),
              [](const auto& a, const auto& b) { return std::tuple(a.vertex, a.edge) < std::tuple(b.vertex, b.edge); });
    label_.resize(edges_of_.size());
  }

  /// The first place of v in edges_of_; label_ holds its label there.
  std::size_t place_of(VertexId v) const {
    const auto it = std::lower_bound(edges_of_.begin(), edges_of_.end(), v,
                                     [](const EdgeAtVertex& e, VertexId value) { return e.vertex < value; });
    return static_cast<std::size_t>(it - edges_of_.begin());
  }

  /// Labels spread from the rim and the generators along the gap's edges. False where a vertex is left without one.
  bool find_labels() {
    collect_vertices();
    std::vector<std::size_t> known;
    const auto learn = [&](VertexId v, GeneratorId g) {
      const std::size_t i = place_of(v);
      if (label_[i].valid()) return;
      label_[i] = g;
      known.push_back(i);
    };
    for (const EdgeAtVertex& e : edges_of_) {
      if (edges_[e.edge].rim || working_.generator(e.vertex).valid()) learn(e.vertex, labels_.label[e.vertex]);
    }
    for (std::size_t k = 0; k < known.size(); ++k) {
      const VertexId v = edges_of_[known[k]].vertex;
      for (std::size_t i = known[k]; i < edges_of_.size() && edges_of_[i].vertex == v; ++i) {
        const GapEdge& e = edges_[edges_of_[i].edge];
        const HalfedgeId h = mesh_.halfedge(e.edge);
        const bool first = mesh_.from(h) == v;
        learn(first ? mesh_.to(h) : mesh_.from(h), e.crossings.empty() ? label_[known[k]]
                                                   : first             ? e.crossings.back().after
                                                                       : e.crossings.front().before);
      }
    }
    return take_labels();
  }

  bool take_labels() {
    for (std::size_t i = 0; i < edges_of_.size(); ++i) {
      if (i > 0 && edges_of_[i].vertex == edges_of_[i - 1].vertex) continue;
      if (!label_[i].valid()) return false;
      const VertexId v = edges_of_[i].vertex;
      if (labels_.label[v] != label_[i]) grown_.labels.emplace_back(v, label_[i]);
    }
    return true;
  }

  bool edges_agree() const {
    for (const GapEdge& e : edges_) {
      const HalfedgeId h = mesh_.halfedge(e.edge);
      const GeneratorId from = label_[place_of(mesh_.from(h))], to = label_[place_of(mesh_.to(h))];
      if (e.crossings.empty() ? from != to : e.crossings.front().before != from || e.crossings.back().after != to) {
        return false;
      }
    }
    return true;
  }

  Vec2 place(const GapArc& arc, int node_index) const {
    const GapNode& node = grown_.nodes[static_cast<std::size_t>(node_index)];
    const FaceLayout layout(mesh_, arc.face);
    if (node.kind == GapNode::Kind::branch) return layout.at(node.bary);
    const Crossing& c = crossing_of(node);
    HalfedgeId h = mesh_.halfedge(c.edge);
    const bool own = Mesh::face(h) == arc.face;
    if (!own) h = mesh_.twin(h);
    return layout.at(edge_point(h, own ? c.t : 1 - c.t).bary);
  }

  /// Round a branch point the cells come in the same order as the arcs.
  bool branches_turn_left() const {
    for (std::size_t n = 0; n < grown_.nodes.size(); ++n) {
      if (grown_.nodes[n].kind != GapNode::Kind::branch) continue;
      struct Spoke {
        Vec2 way;
        GeneratorId left, right;
      };
      std::vector<Spoke> spokes;
      for (const GapArc& arc : grown_.arcs) {
        const bool begins = arc.begin == static_cast<int>(n), ends = arc.end == static_cast<int>(n);
        if (!begins && !ends) continue;
        const Vec2 way = place(arc, begins ? arc.end : arc.begin) - place(arc, static_cast<int>(n));
        spokes.push_back({way, begins ? arc.left : arc.right, begins ? arc.right : arc.left});
      }
      if (spokes.size() != 3) return false;
      if (spokes[1].right != spokes[0].left) std::swap(spokes[1], spokes[2]);
      int left_turns = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Spoke& next = spokes[(i + 1) % 3];
        if (next.right != spokes[i].left) return false;
        left_turns += cross(spokes[i].way, next.way) > 0;
      }
      if (left_turns < 2) return false;
    }
    return true;
  }

  bool arcs_stay_apart() const {
    for (std::size_t i = 0; i < grown_.arcs.size(); ++i) {
      for (std::size_t j = i + 1; j < grown_.arcs.size(); ++j) {
        const GapArc &a = grown_.arcs[i], &b = grown_.arcs[j];
        if (a.face != b.face || a.begin == b.begin || a.begin == b.end || a.end == b.begin || a.end == b.end) continue;
        const PlaneSegment p{place(a, a.begin), place(a, a.end)}, q{place(b, b.begin), place(b, b.end)};
        if (!lie_on_one_side(p, q.from, q.to) && !lie_on_one_side(q, p.from, p.to)) return false;
      }
    }
    return true;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const NearestLabels& labels_;
  const Crossings& crossings_;
  const Gap& gap_;
  GrownGap& grown_;
  std::vector<GapEdge> edges_;           // ascending
  std::vector<Crossing> gap_crossings_;  // of all of them, ascending by (edge, t)
  std::vector<EdgeAtVertex> edges_of_;   // ascending by (vertex, edge)
  std::vector<GeneratorId> label_;       // of the vertex whose first place this is; invalid elsewhere
};

}  // namespace

bool check_growth(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
                  GrownGap& grown) {
  return GrowthCheck(working, labels, crossings, gap, grown).run();
}

}  // namespace gvd
