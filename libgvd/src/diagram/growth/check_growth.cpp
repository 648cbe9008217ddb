// Check of a grown gap. The paper takes the result of growth as it is (section 4.3).
//
// Nothing that the growth computed is trusted: nodes, edges, labels and arcs are compared with each other and with the
// crossings on the rim. The checks run from the cheap to the costly one, and each relies on those before it: positions
// of arcs, for example, are read only once the arcs lie in the gap's faces.
// Invariant: a gap that passes fits the diagram around it. Its cells stay connected along the edges, and its arcs form
// a planar graph in every face. A gap that fails is not mended: it grows again by other rules or with more faces, and
// is assembled in the end. So a check that is too strict costs time, and one that is too lax would cost validity.
#include "diagram/growth/check_growth.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// The crossing that a node is, on the rim or new; not for branch points.
const Crossing& crossing_of(const GapNode& node, const Crossings& crossings) {
  return node.kind == GapNode::Kind::rim ? crossings[node.rim] : node.crossing;
}

/// Whether an arc may begin or end at a node: the node lies in its face, and between its two cells.
bool fits(const Mesh& mesh, const Crossings& crossings, const GapNode& node, const GapArc& arc, bool begins) {
  const GeneratorId left = begins ? arc.left : arc.right, right = begins ? arc.right : arc.left;
  if (node.kind == GapNode::Kind::branch) {
    return node.face == arc.face && *std::min_element(node.bary.begin(), node.bary.end()) >= 0;
  }
  const Crossing& c = crossing_of(node, crossings);
  const HalfedgeId h = mesh.halfedge(c.edge), twin = mesh.twin(h);
  // Seen from the crossing into the face of h, the edge's first vertex lies on the left.
  if (Mesh::face(h) == arc.face) return left == c.before && right == c.after;
  return twin.valid() && Mesh::face(twin) == arc.face && left == c.after && right == c.before;
}

/// Whether a node ends as many arcs as it must; `faces` are theirs.
bool has_its_arcs(const Mesh& mesh, const GapNode& node, const std::vector<FaceId>& faces) {
  if (node.kind == GapNode::Kind::branch) return faces.size() == 3;
  if (node.kind == GapNode::Kind::rim || mesh.is_boundary(node.crossing.edge)) return faces.size() == 1;
  return faces.size() == 2 && faces[0] != faces[1];
}

/// Whether every crossing of the rim is exactly one node.
bool rim_is_complete(const GapEdges& edges, const GrownGap& grown) {
  std::vector<CrossingId> rim;
  for (const GapNode& node : grown.nodes) {
    if (node.kind == GapNode::Kind::rim) rim.push_back(node.rim);
  }
  std::sort(rim.begin(), rim.end());
  return rim.size() == edges.rim_crossing_count() && std::adjacent_find(rim.begin(), rim.end()) == rim.end();
}

/// Labels of a gap's vertices that follow from the labels on its rim, those of its generators, and its crossings.
class GapLabels {
 public:
  GapLabels(const WorkingMesh& working, const NearestLabels& labels, const std::vector<GapEdge>& edges)
      : mesh_(working.mesh()), edges_(edges) {
    for (const GapEdge& e : edges) {
      const HalfedgeId h = mesh_.halfedge(e.edge);
      edges_at_[mesh_.from(h)].push_back(&e);
      edges_at_[mesh_.to(h)].push_back(&e);
    }
    for (const auto& [v, around] : edges_at_) {
      const bool on_rim = std::any_of(around.begin(), around.end(), [](const GapEdge* e) { return e->rim; });
      if (on_rim || working.generator(v).valid()) set_label(v, labels.label[v]);
    }
    for (std::size_t k = 0; k < labelled_.size(); ++k) spread_from(labelled_[k]);
  }

  bool are_complete_and_agree() const {
    return label_.size() == edges_at_.size() && std::all_of(edges_.begin(), edges_.end(), [&](const GapEdge& e) {
             const HalfedgeId h = mesh_.halfedge(e.edge);
             const GeneratorId from = label_.at(mesh_.from(h)), to = label_.at(mesh_.to(h));
             if (e.crossings.empty()) return from == to;
             return e.crossings.front().before == from && e.crossings.back().after == to;
           });
  }

  /// Ascending by vertex.
  const std::map<VertexId, GeneratorId>& all() const { return label_; }

 private:
  void set_label(VertexId v, GeneratorId g) {
    if (g.valid() && label_.emplace(v, g).second) labelled_.push_back(v);
  }

  void spread_from(VertexId v) {
    for (const GapEdge* e : edges_at_[v]) {
      const HalfedgeId h = mesh_.halfedge(e->edge);
      const bool forwards = mesh_.from(h) == v;
      const VertexId other = forwards ? mesh_.to(h) : mesh_.from(h);
      if (e->crossings.empty()) {
        set_label(other, label_[v]);
      } else {
        set_label(other, forwards ? e->crossings.back().after : e->crossings.front().before);
      }
    }
  }

  const Mesh& mesh_;
  const std::vector<GapEdge>& edges_;
  std::map<VertexId, std::vector<const GapEdge*>> edges_at_;
  std::map<VertexId, GeneratorId> label_;
  std::vector<VertexId> labelled_;  // in the order of labelling
};

class GapArcCheck {
 public:
  GapArcCheck(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown)
      : mesh_(mesh), crossings_(crossings), grown_(grown) {}

  bool run() const {
    for (int n = 0; n < std::ssize(grown_.nodes); ++n) {
      if (grown_.nodes[n].kind == GapNode::Kind::branch && !turns_left(n)) return false;
    }
    for (std::size_t i = 0; i < grown_.arcs.size(); ++i) {
      for (std::size_t j = i + 1; j < grown_.arcs.size(); ++j) {
        if (cross_each_other(grown_.arcs[i], grown_.arcs[j])) return false;
      }
    }
    return true;
  }

 private:
  /// An arc as it leaves a branch point.
  struct Spoke {
    Vec2 direction;
    GeneratorId left, right;
  };

  /// Position of a node of the arc, in the plane of the arc's face.
  Vec2 position_of(const GapArc& arc, int node_index) const {
    const GapNode& node = grown_.nodes[node_index];
    const FaceLayout layout(mesh_, arc.face);
    if (node.kind == GapNode::Kind::branch) return layout.at(node.bary);
    const Crossing& c = crossing_of(node, crossings_);
    const HalfedgeId h = mesh_.halfedge(c.edge);
    const bool own = Mesh::face(h) == arc.face;
    return layout.at((own ? edge_point(h, c.t) : edge_point(mesh_.twin(h), 1 - c.t)).bary);
  }

  std::vector<Spoke> spokes_at(int node) const {
    std::vector<Spoke> spokes;
    for (const GapArc& arc : grown_.arcs) {
      const bool begins = arc.begin == node, ends = arc.end == node;
      if (!begins && !ends) continue;
      const Vec2 direction = position_of(arc, begins ? arc.end : arc.begin) - position_of(arc, node);
      spokes.push_back({direction, begins ? arc.left : arc.right, begins ? arc.right : arc.left});
    }
    return spokes;
  }

  /// Whether the three arcs at a branch point go round it counter-clockwise in the order of their cells. One of the
  /// three angles may be larger than a half turn.
  bool turns_left(int node) const {
    std::vector<Spoke> spokes = spokes_at(node);
    if (spokes.size() != 3) return false;
    if (spokes[1].right != spokes[0].left) std::swap(spokes[1], spokes[2]);
    int left_turns = 0;
    for (int i = 0; i < 3; ++i) {
      const Spoke& next = spokes[(i + 1) % 3];
      if (next.right != spokes[i].left) return false;
      left_turns += cross(spokes[i].direction, next.direction) > 0;
    }
    return left_turns >= 2;
  }

  /// Arcs that end at a common node do not count as crossing.
  bool cross_each_other(const GapArc& a, const GapArc& b) const {
    if (a.face != b.face || a.begin == b.begin || a.begin == b.end || a.end == b.begin || a.end == b.end) return false;
    const PlaneSegment p{position_of(a, a.begin), position_of(a, a.end)};
    const PlaneSegment q{position_of(b, b.begin), position_of(b, b.end)};
    return !lie_on_one_side(p, q.from, q.to) && !lie_on_one_side(q, p.from, p.to);
  }

  const Mesh& mesh_;
  const Crossings& crossings_;
  const GrownGap& grown_;
};

}  // namespace

GapEdges::GapEdges(const Mesh& mesh, const Crossings& crossings, const Gap& gap, const GrownGap& grown) {
  collect_edges(mesh, gap);
  collect_crossings(crossings, grown);
  std::size_t next = 0;
  for (GapEdge& e : edges_) {
    const std::size_t first = next;
    while (next < crossings_.size() && crossings_[next].edge == e.edge) ++next;
    e.crossings = std::span(crossings_).subspan(first, next - first);
  }
}

void GapEdges::collect_edges(const Mesh& mesh, const Gap& gap) {
  for (const FaceId f : gap.faces) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      edges_.push_back({mesh.edge(h), is_rim(mesh, gap, h), {}});
    }
  }
  std::ranges::sort(edges_, {}, &GapEdge::edge);
  const auto same = [](const GapEdge& a, const GapEdge& b) { return a.edge == b.edge; };
  edges_.erase(std::unique(edges_.begin(), edges_.end(), same), edges_.end());
}

void GapEdges::collect_crossings(const Crossings& crossings, const GrownGap& grown) {
  for (const GapEdge& e : edges_) {
    for (std::int32_t k = 0; e.rim && k < crossings.count(e.edge); ++k) {
      crossings_.push_back(crossings[CrossingId(crossings.first(e.edge).value() + k)]);
    }
  }
  for (const GapNode& node : grown.nodes) {
    if (node.kind == GapNode::Kind::crossing) crossings_.push_back(node.crossing);
  }
  std::ranges::sort(crossings_, {}, [](const Crossing& c) { return std::tuple(c.edge, c.t); });
}

std::size_t GapEdges::rim_crossing_count() const {
  std::size_t count = 0;
  for (const GapEdge& e : edges_) count += e.rim ? e.crossings.size() : 0;
  return count;
}

bool GapEdges::are_consistent() const {
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

bool check_gap_nodes(const Mesh& mesh, const Crossings& crossings, const Gap& gap, const GapEdges& edges,
                     const GrownGap& grown) {
  std::vector<std::vector<FaceId>> faces(grown.nodes.size());  // of the arcs that end at each node
  for (const GapArc& arc : grown.arcs) {
    if (!gap.contains(arc.face)) return false;
    for (const bool begins : {true, false}) {
      const int n = begins ? arc.begin : arc.end;
      if (!fits(mesh, crossings, grown.nodes[n], arc, begins)) return false;
      faces[n].push_back(arc.face);
    }
  }
  for (std::size_t n = 0; n < grown.nodes.size(); ++n) {
    if (!has_its_arcs(mesh, grown.nodes[n], faces[n])) return false;
  }
  return rim_is_complete(edges, grown);
}

std::optional<std::vector<std::pair<VertexId, GeneratorId>>> find_moved_labels(const WorkingMesh& working,
                                                                               const NearestLabels& labels,
                                                                               const GapEdges& gap_edges) {
  const GapLabels implied(working, labels, gap_edges.edges());
  if (!implied.are_complete_and_agree()) return std::nullopt;
  std::vector<std::pair<VertexId, GeneratorId>> moved;
  for (const auto& [v, g] : implied.all()) {
    if (labels.label[v] != g) moved.emplace_back(v, g);
  }
  return moved;
}

bool check_gap_arcs(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown) {
  return GapArcCheck(mesh, crossings, grown).run();
}

bool check_growth(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
                  GrownGap& grown) {
  const GapEdges edges(working.mesh(), crossings, gap, grown);
  if (!check_gap_nodes(working.mesh(), crossings, gap, edges, grown) || !edges.are_consistent()) return false;
  auto moved = find_moved_labels(working, labels, edges);
  if (!moved || !check_gap_arcs(working.mesh(), crossings, grown)) return false;
  grown.labels = std::move(*moved);
  return true;
}

}  // namespace gvd
