#include "diagram/growth/check_gap_nodes.hpp"

#include <algorithm>
#include <vector>

namespace gvd {
namespace {

class GapNodeCheck {
 public:
  GapNodeCheck(const Mesh& mesh, const Crossings& crossings, const Gap& gap, const GrownGap& grown)
      : mesh_(mesh), crossings_(crossings), gap_(gap), grown_(grown), faces_(grown.nodes.size()) {}

  bool run(const GapEdges& edges) {
    for (const GapArc& arc : grown_.arcs) {
      const auto begin = static_cast<std::size_t>(arc.begin), end = static_cast<std::size_t>(arc.end);
      if (!fits(grown_.nodes[begin], arc.face, arc.left, arc.right)) return false;
      if (!fits(grown_.nodes[end], arc.face, arc.right, arc.left)) return false;
      faces_[begin].push_back(arc.face);
      faces_[end].push_back(arc.face);
    }
    for (std::size_t n = 0; n < grown_.nodes.size(); ++n) {
      if (!has_its_arcs(grown_.nodes[n], faces_[n])) return false;
    }
    return rim_is_complete(edges);
  }

 private:
  /// Whether an arc in f, with these cells on its sides when it leaves the node, may end at the node.
  bool fits(const GapNode& node, FaceId f, GeneratorId left, GeneratorId right) const {
    if (!gap_.contains(f)) return false;
    if (node.kind == GapNode::Kind::branch) {
      return node.face == f && *std::min_element(node.bary.begin(), node.bary.end()) >= 0;
    }
    const Crossing& c = node.kind == GapNode::Kind::rim ? crossings_[node.rim] : node.crossing;
    const HalfedgeId h = mesh_.halfedge(c.edge), twin = mesh_.twin(h);
    // Seen from the crossing into the face of h, the edge's first vertex lies on the left.
    if (Mesh::face(h) == f) return left == c.before && right == c.after;
    return twin.valid() && Mesh::face(twin) == f && left == c.after && right == c.before;
  }

  bool has_its_arcs(const GapNode& node, const std::vector<FaceId>& faces) const {
    if (node.kind == GapNode::Kind::branch) return faces.size() == 3;
    if (node.kind == GapNode::Kind::rim || mesh_.is_boundary(node.crossing.edge)) return faces.size() == 1;
    return faces.size() == 2 && faces[0] != faces[1];
  }

  bool rim_is_complete(const GapEdges& edges) const {
    std::vector<CrossingId> rim;
    for (const GapNode& node : grown_.nodes) {
      if (node.kind == GapNode::Kind::rim) rim.push_back(node.rim);
    }
    std::sort(rim.begin(), rim.end());
    return rim.size() == edges.rim_crossing_count() && std::adjacent_find(rim.begin(), rim.end()) == rim.end();
  }

  const Mesh& mesh_;
  const Crossings& crossings_;
  const Gap& gap_;
  const GrownGap& grown_;
  std::vector<std::vector<FaceId>> faces_;  // per node: those of the arcs that end at it
};

}  // namespace

bool check_gap_nodes(const Mesh& mesh, const Crossings& crossings, const Gap& gap, const GapEdges& edges,
                     const GrownGap& grown) {
  return GapNodeCheck(mesh, crossings, gap, grown).run(edges);
}

}  // namespace gvd
