#include "diagram/growth/check_gap_arcs.hpp"

#include <utility>
#include <vector>

#include "base/plane.hpp"
#include "geodesic/field/face_layout.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

class GapArcCheck {
 public:
  GapArcCheck(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown)
      : mesh_(mesh), crossings_(crossings), grown_(grown) {}

  bool run() const {
    for (std::size_t n = 0; n < grown_.nodes.size(); ++n) {
      if (grown_.nodes[n].kind == GapNode::Kind::branch && !turns_left(static_cast<int>(n))) return false;
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
    const Crossing& c = node.kind == GapNode::Kind::rim ? crossings_[node.rim] : node.crossing;
    HalfedgeId h = mesh_.halfedge(c.edge);
    const bool own = Mesh::face(h) == arc.face;
    if (!own) h = mesh_.twin(h);
    return layout.at(edge_point(h, own ? c.t : 1 - c.t).bary);
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
    for (std::size_t i = 0; i < 3; ++i) {
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

bool check_gap_arcs(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown) {
  return GapArcCheck(mesh, crossings, grown).run();
}

}  // namespace gvd
