// Checks a grown gap. The paper takes the result of growth as it is (section 4.3).
//
// The check trusts nothing that the growth computed: it compares nodes, edges, labels and arcs with each other and with
// the crossings on the rim. The checks run from the cheapest to the most expensive, and each relies on the checks
// before it. For example, positions of arcs are read only once the arcs are known to lie in the gap's faces.
// Invariant: a gap that passes fits the diagram around it. Its cells stay connected along the edges, and its arcs form
// a planar graph in every face. A gap that fails is not repaired: it grows again by other rules or with more faces, and
// is assembled in the end. A check that is too strict therefore only costs time, whereas one that is too lax would make
// diagrams invalid.
#include "diagram/growth/check_growth.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// The crossing at a node, on the rim or new. The node must not be a branch point.
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

/// Whether as many arcs as necessary end at a node. `faces` are the faces of these arcs.
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

/// The labels that spread from a gap's rim and its generators along its edges, and change where edges are crossed.
std::map<VertexId, GeneratorId> spread_labels(const WorkingMesh& working, const NearestLabels& labels,
                                              const std::vector<GapEdge>& edges) {
  const Mesh& mesh = working.mesh();
  std::map<VertexId, std::vector<const GapEdge*>> edges_at;
  for (const GapEdge& e : edges) {
    const HalfedgeId h = mesh.halfedge(e.edge);
    edges_at[mesh.from(h)].push_back(&e);
    edges_at[mesh.to(h)].push_back(&e);
  }
  std::map<VertexId, GeneratorId> implied;
  std::vector<VertexId> labelled;  // in the order of labelling
  const auto set_label = [&](VertexId v, GeneratorId g) {
    if (g.valid() && implied.emplace(v, g).second) labelled.push_back(v);
  };
  for (const auto& [v, around] : edges_at) {
    const bool on_rim = std::ranges::any_of(around, [](const GapEdge* e) { return e->rim; });
    if (on_rim || working.generator(v).valid()) set_label(v, labels.label[v]);
  }
  for (std::size_t k = 0; k < labelled.size(); ++k) {
    const VertexId v = labelled[k];
    for (const GapEdge* e : edges_at[v]) {
      const HalfedgeId h = mesh.halfedge(e->edge);
      const bool forwards = mesh.from(h) == v;
      const VertexId other = forwards ? mesh.to(h) : mesh.from(h);
      if (e->crossings.empty()) {
        set_label(other, implied[v]);
      } else {
        set_label(other, forwards ? e->crossings.back().after : e->crossings.front().before);
      }
    }
  }
  return implied;
}

/// The positions of an arc's two nodes, in the plane of its face.
PlaneSegment segment_of(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown, const GapArc& arc) {
  const FaceLayout layout(mesh, arc.face);
  const auto position = [&](const GapNode& node) {
    if (node.kind == GapNode::Kind::branch) return layout.at(node.bary);
    const Crossing& c = crossing_of(node, crossings);
    const HalfedgeId h = mesh.halfedge(c.edge);
    const bool own = Mesh::face(h) == arc.face;
    return layout.at((own ? edge_point(h, c.t) : edge_point(mesh.twin(h), 1 - c.t)).bary);
  };
  return {position(grown.nodes[arc.begin]), position(grown.nodes[arc.end])};
}

/// An arc as it leaves a branch point.
struct BranchSpoke {
  Vec2 direction;
  GeneratorId left, right;
};

/// Whether the three arcs at a branch point follow each other counter-clockwise in the order of their cells. One of the
/// three angles may be larger than a half turn. `segments` are the segments of all arcs.
bool turns_left_at(int node, const std::vector<GapArc>& arcs, const std::vector<PlaneSegment>& segments) {
  std::vector<BranchSpoke> spokes;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Vec2 way = segments[i].to - segments[i].from;
    if (arcs[i].begin == node) {
      spokes.push_back({way, arcs[i].left, arcs[i].right});
    } else if (arcs[i].end == node) {
      spokes.push_back({-way, arcs[i].right, arcs[i].left});
    }
  }
  if (spokes.size() != 3) return false;
  if (spokes[1].right != spokes[0].left) std::swap(spokes[1], spokes[2]);
  int left_turns = 0;
  for (int i = 0; i < 3; ++i) {
    const BranchSpoke& next = spokes[(i + 1) % 3];
    if (next.right != spokes[i].left) return false;
    left_turns += cross(spokes[i].direction, next.direction) > 0;
  }
  return left_turns >= 2;
}

bool have_common_node(const GapArc& a, const GapArc& b) {
  return a.begin == b.begin || a.begin == b.end || a.end == b.begin || a.end == b.end;
}

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
  std::vector<std::vector<FaceId>> faces(grown.nodes.size());  // faces of the arcs that end at each node
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
  const Mesh& mesh = working.mesh();
  const std::map<VertexId, GeneratorId> implied = spread_labels(working, labels, gap_edges.edges());
  for (const GapEdge& e : gap_edges.edges()) {
    const HalfedgeId h = mesh.halfedge(e.edge);
    const auto from = implied.find(mesh.from(h)), to = implied.find(mesh.to(h));
    if (from == implied.end() || to == implied.end()) return std::nullopt;
    const bool agrees = e.crossings.empty()
                            ? from->second == to->second
                            : e.crossings.front().before == from->second && e.crossings.back().after == to->second;
    if (!agrees) return std::nullopt;
  }
  std::vector<std::pair<VertexId, GeneratorId>> moved;
  for (const auto& [v, g] : implied) {
    if (labels.label[v] != g) moved.emplace_back(v, g);
  }
  return moved;
}

bool check_gap_arcs(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown) {
  const std::vector<GapArc>& arcs = grown.arcs;
  std::vector<PlaneSegment> segments;
  for (const GapArc& arc : arcs) segments.push_back(segment_of(mesh, crossings, grown, arc));
  for (int n = 0; n < std::ssize(grown.nodes); ++n) {
    if (grown.nodes[n].kind == GapNode::Kind::branch && !turns_left_at(n, arcs, segments)) return false;
  }
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (std::size_t j = i + 1; j < arcs.size(); ++j) {
      if (arcs[i].face != arcs[j].face || have_common_node(arcs[i], arcs[j])) continue;
      const PlaneSegment &p = segments[i], &q = segments[j];
      if (!lie_on_one_side(p, q.from, q.to) && !lie_on_one_side(q, p.from, p.to)) return false;
    }
  }
  return true;
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
