#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "diagram/growing_end.hpp"
#include "diagram/growth.hpp"

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
  struct EdgeRuns {
    std::vector<Crossing> crossings;  // ascending in t
    bool rim = false;
  };

  /// Every edge of the gap with its crossings: those of the rim as they were, inside it those that grew.
  void collect_edges() {
    for (const FaceId f : gap_.faces) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId h = Mesh::halfedge(f, corner), twin = mesh_.twin(h);
        EdgeRuns& runs = edges_[mesh_.edge(h)];
        if (!twin.valid() || gap_.contains(Mesh::face(twin)) || runs.rim) continue;
        runs.rim = true;
        for (std::int32_t k = 0; k < crossings_.count(mesh_.edge(h)); ++k) {
          runs.crossings.push_back(crossings_[CrossingId(crossings_.first(mesh_.edge(h)).value() + k)]);
        }
      }
    }
    for (const GapNode& node : grown_.nodes) {
      if (node.kind == GapNode::Kind::crossing) edges_[node.crossing.edge].crossings.push_back(node.crossing);
    }
    for (auto& [e, runs] : edges_) {
      std::sort(runs.crossings.begin(), runs.crossings.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
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
    std::set<CrossingId> rim;
    for (std::size_t n = 0; n < grown_.nodes.size(); ++n) {
      const GapNode& node = grown_.nodes[n];
      if (node.kind == GapNode::Kind::rim && !rim.insert(node.rim).second) return false;
      if (faces[n].size() != arc_count(node)) return false;
      if (node.kind == GapNode::Kind::crossing && faces[n].size() == 2 && faces[n][0] == faces[n][1]) return false;
    }
    std::size_t rim_crossings = 0;
    for (const auto& [e, runs] : edges_) rim_crossings += runs.rim ? runs.crossings.size() : 0;
    return rim.size() == rim_crossings;
  }

  std::size_t arc_count(const GapNode& node) const {
    if (node.kind == GapNode::Kind::branch) return 3;
    return node.kind == GapNode::Kind::rim || mesh_.is_boundary(node.crossing.edge) ? 1 : 2;
  }

  bool edges_keep_gaps() const {
    for (const auto& [e, runs] : edges_) {
      if (!runs.crossings.empty() &&
          (runs.crossings.front().t < kCrossingGap || runs.crossings.back().t > 1 - kCrossingGap)) {
        return false;
      }
      for (std::size_t i = 1; i < runs.crossings.size(); ++i) {
        if (runs.crossings[i].t - runs.crossings[i - 1].t < kCrossingGap) return false;
        if (runs.crossings[i].before != runs.crossings[i - 1].after) return false;
      }
    }
    return true;
  }

  /// Labels spread from the rim and the generators along the gap's edges.
  bool find_labels() {
    std::vector<VertexId> known;
    const auto learn = [&](VertexId v, GeneratorId g) {
      if (label_.emplace(v, g).second) known.push_back(v);
    };
    std::map<VertexId, std::vector<EdgeId>> edges_of;
    for (const auto& [e, runs] : edges_) {
      const HalfedgeId h = mesh_.halfedge(e);
      for (const VertexId v : {mesh_.from(h), mesh_.to(h)}) {
        edges_of[v].push_back(e);
        if (runs.rim || working_.generator(v).valid()) learn(v, labels_.label[v]);
      }
    }
    for (std::size_t i = 0; i < known.size(); ++i) {
      const VertexId v = known[i];
      for (const EdgeId e : edges_of[v]) {
        const auto& crossings = edges_[e].crossings;
        const HalfedgeId h = mesh_.halfedge(e);
        const bool first = mesh_.from(h) == v;
        const GeneratorId own = label_[v];
        learn(first ? mesh_.to(h) : mesh_.from(h), crossings.empty() ? own
                                                   : first           ? crossings.back().after
                                                                     : crossings.front().before);
      }
    }
    for (const auto& [v, g] : label_) {
      if (labels_.label[v] != g) grown_.labels.emplace_back(v, g);
    }
    return true;
  }

  bool edges_agree() const {
    for (const auto& [e, runs] : edges_) {
      const auto from = label_.find(mesh_.from(mesh_.halfedge(e))), to = label_.find(mesh_.to(mesh_.halfedge(e)));
      if (from == label_.end() || to == label_.end()) return false;
      if (runs.crossings.empty()
              ? from->second != to->second
              : runs.crossings.front().before != from->second || runs.crossings.back().after != to->second) {
        return false;
      }
    }
    return true;
  }

  Vec2 place(const GapArc& arc, int node_index) const {
    const GapNode& node = grown_.nodes[static_cast<std::size_t>(node_index)];
    const auto corner = flatten_face(mesh_, arc.face);
    if (node.kind == GapNode::Kind::branch) {
      return node.bary[0] * corner[0] + node.bary[1] * corner[1] + node.bary[2] * corner[2];
    }
    const Crossing& c = crossing_of(node);
    HalfedgeId h = mesh_.halfedge(c.edge);
    const bool own = Mesh::face(h) == arc.face;
    if (!own) h = mesh_.twin(h);
    const auto i = static_cast<std::size_t>(Mesh::corner(h));
    const double t = own ? c.t : 1 - c.t;
    return (1 - t) * corner[i] + t * corner[(i + 1) % 3];
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
        const Vec2 p = place(a, a.begin), q = place(a, a.end), r = place(b, b.begin), s = place(b, b.end);
        const bool apart_a = cross(q - p, r - p) * cross(q - p, s - p) > 0;
        const bool apart_b = cross(s - r, p - r) * cross(s - r, q - r) > 0;
        if (!apart_a && !apart_b) return false;
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
  std::map<EdgeId, EdgeRuns> edges_;
  std::map<VertexId, GeneratorId> label_;
};

}  // namespace

bool check_growth(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
                  GrownGap& grown) {
  return GrowthCheck(working, labels, crossings, gap, grown).run();
}

}  // namespace gvd
