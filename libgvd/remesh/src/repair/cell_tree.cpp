#include "repair/cell_tree.hpp"

#include <functional>
#include <queue>
#include <utility>

#include "mesh/vertex_ring.hpp"

namespace gvd {

CellTree::CellTree(const CutMesh& cut)
    : cut_(cut),
      distance_(static_cast<std::size_t>(cut.mesh.vertex_count()), kInfinity),
      parent_(static_cast<std::size_t>(cut.mesh.vertex_count())) {}

void CellTree::grow(VertexId root, GeneratorId cell) {
  clear();
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](VertexId v, double distance, VertexId parent) {
    if (distance >= distance_[v]) return;
    distance_[v] = distance;
    parent_[v] = parent;
    touched_.push_back(v);
    queue.emplace(distance, v);
  };
  offer(root, 0, VertexId());
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distance_[v]) continue;
    for_each_outgoing(cut_.mesh, v, [&, from = v, so_far = distance](HalfedgeId h) {
      if (!is_in_cell(cut_, h, cell)) return;
      const HalfedgeId incoming = Mesh::previous(h);
      offer(cut_.mesh.to(h), so_far + cut_.mesh.length(h), from);
      offer(cut_.mesh.from(incoming), so_far + cut_.mesh.length(incoming), from);
    });
  }
}

void CellTree::clear() {
  for (const VertexId v : touched_) {
    distance_[v] = kInfinity;
    parent_[v] = VertexId();
  }
  touched_.clear();
}

std::vector<VertexId> CellTree::path_to_root(VertexId v) const {
  std::vector<VertexId> vertices;
  for (; v.valid(); v = parent_[v]) vertices.push_back(v);
  return vertices;
}

}  // namespace gvd
