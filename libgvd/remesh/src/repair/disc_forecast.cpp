// Which cells would be discs with one more generator, by the labels of vertices.
//
// A subcomplex of the mesh with the vertices of one label, and all edges and faces between them, has the shape of its
// cell unless the cell is narrower than its faces. Its Euler characteristic changes only at the vertices that change
// their label, so that the rest of the mesh is not looked at. A forecast only ranks points; a diagram decides.
#include "repair/disc_forecast.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "mesh/vertex_ring.hpp"

namespace gvd {

int count_disc_defects(const Cell& cell) { return std::abs(cell.euler_characteristic - 1) + cell.components - 1; }

namespace {

/// The label that all of some vertices have; invalid where they differ.
template <class Label>
GeneratorId common_label(const std::vector<VertexId>& vertices, const Label& label) {
  const GeneratorId first = label(vertices.front());
  const auto has_first = [&](VertexId v) { return label(v) == first; };
  return std::ranges::all_of(vertices, has_first) ? first : GeneratorId();
}

}  // namespace

DiscForecast::DiscForecast(const Mesh& mesh)
    : mesh_(mesh),
      march_(mesh, Front::circle),
      distance_(mesh.vertex_count(), kInfinity),
      is_moved_(mesh.vertex_count(), 0),
      is_counted_(mesh.face_count(), 0) {}

void DiscForecast::take(const Diagram& diagram) {
  diagram_ = &diagram;
  new_cell_ = GeneratorId(diagram.generators.size());
  euler_.assign(diagram.generators.size(), 0);
  vertices_.assign(diagram.generators.size(), 0);
  const auto count = [&](const std::vector<VertexId>& vertices, int sign) {
    const GeneratorId cell = common_label(vertices, [&](VertexId v) { return diagram.vertex_label[v]; });
    if (cell.valid()) euler_[cell] += sign;
  };
  for (const VertexId v : mesh_.vertices()) {
    distance_[march_.fans().place(v)] = diagram.vertex_label[v].valid() ? diagram.vertex_distance[v] : 0;
    count({v}, 1);
    if (diagram.vertex_label[v].valid()) ++vertices_[diagram.vertex_label[v]];
  }
  for (const EdgeId e : mesh_.edges()) {
    const HalfedgeId h = mesh_.halfedge(e);
    count({mesh_.from(h), mesh_.to(h)}, -1);
  }
  for (const FaceId f : mesh_.faces()) {
    const auto& [a, b, c] = mesh_.vertices(f);
    count({a, b, c}, 1);
  }
  tells_.assign(diagram.generators.size(), 0);
  for (const Cell& cell : diagram.cells) tells_[cell.generator] = euler_[cell.generator] == cell.euler_characteristic;
}

void DiscForecast::add(GeneratorId cell, int euler) {
  if (!cell.valid()) return;
  const auto found = std::ranges::find(changes_, cell, &Change::cell);
  if (found != changes_.end()) {
    found->euler += euler;
  } else {
    changes_.push_back({cell, euler});
  }
}

/// Moves a vertex, an edge or a face, which counts `sign` in an Euler characteristic, from the cell of its label to the
/// cell of the label that it would have.
void DiscForecast::replace(const std::vector<VertexId>& corners, int sign) {
  add(common_label(corners, [&](VertexId v) { return diagram_->vertex_label[v]; }), -sign);
  add(common_label(corners, [&](VertexId v) { return label_after(v); }), sign);
}

DiscForecast::Outcome DiscForecast::find(const SurfacePoint& point, GeneratorId divided) {
  march_.run(point, kInfinity, &distance_);
  ++run_;
  changes_.clear();
  std::vector<VertexId> moved;
  std::int32_t taken = 0;  // of the divided cell
  for (const PlaceId p : march_.reached()) {
    if (!(march_.distance(p) < distance_[p])) continue;
    moved.push_back(march_.fans().vertex(p));
    is_moved_[moved.back()] = run_;
    taken += diagram_->vertex_label[moved.back()] == divided;
  }
  for (const VertexId v : moved) replace_around(v);
  Outcome outcome;
  outcome.imbalance = std::abs(vertices_[divided] - 2 * taken);
  if (moved.empty()) return outcome;
  for (const auto& [cell, euler] : changes_) {
    if (cell != new_cell_ && !tells(cell)) continue;
    const int before = cell == new_cell_ ? 0 : std::abs(euler_[cell] - 1);
    const int after = std::abs((cell == new_cell_ ? 0 : euler_[cell]) + euler - 1);
    outcome.defects += after - before;
    outcome.squares += after * after - before * before;
  }
  return outcome;
}

/// Replaces a vertex that would change its cell, and the edges and faces round it, unless another vertex of theirs has
/// replaced them already.
void DiscForecast::replace_around(VertexId v) {
  replace({v}, 1);
  for_each_neighbour(mesh_, v, [&](VertexId w, HalfedgeId) {
    if (is_moved_[w] != run_ || v < w) replace({v, w}, -1);
  });
  for_each_outgoing(mesh_, v, [&](HalfedgeId h) {
    if (std::exchange(is_counted_[Mesh::face(h)], run_) == run_) return;
    const auto& [a, b, c] = mesh_.vertices(Mesh::face(h));
    replace({a, b, c}, 1);
  });
}

}  // namespace gvd
