#include "diagram/growth/gap_edges.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace gvd {

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
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = Mesh::halfedge(f, corner), twin = mesh.twin(h);
      edges_.push_back({mesh.edge(h), twin.valid() && !gap.contains(Mesh::face(twin)), {}});
    }
  }
  std::sort(edges_.begin(), edges_.end(), [](const auto& a, const auto& b) { return a.edge < b.edge; });
  const auto same = [](const auto& a, const auto& b) { return a.edge == b.edge; };
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
  std::sort(crossings_.begin(), crossings_.end(),
            [](const auto& a, const auto& b) { return std::tuple(a.edge, a.t) < std::tuple(b.edge, b.t); });
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

}  // namespace gvd
