// A list of new generators, each with a least distance from all others.
//
// Distances are Euclidean, except for points that are nearly the same in space: they may lie on the two banks of a slit
// or on two sheets that touch. For these, a search over the faces within the distance tells whether one connected part
// of the surface holds both. Where the distance is less than the surface's features, this agrees with the geodesic one.

#include <cmath>

#include "base/least.hpp"
#include "gvd/closest_point.hpp"
#include "repair/repair_steps.hpp"

namespace gvd {
bool are_near(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double radius) {
  if (!((position(mesh, b) - position(mesh, a)).norm() <= radius)) return false;
  const std::vector<FaceId> goal = faces_around(mesh, b), reached = faces_within(mesh, a, radius);
  return std::find_first_of(reached.begin(), reached.end(), goal.begin(), goal.end()) != reached.end();
}

AddedGenerators::AddedGenerators(const Mesh& mesh, const std::vector<SurfacePoint>& existing, std::size_t max_count)
    : mesh_(mesh),
      spacing_(kMinAddedSpacing * mesh.bbox_diagonal()),
      max_count_(max_count),
      component_(compute_face_components(mesh)),
      of_component_(mesh.face_count()) {
  for (const SurfacePoint& g : existing) insert(g);
}

double AddedGenerators::clearance(const SurfacePoint& point) const {
  const Vec3 at = position(mesh_, point);
  double least = kInfinity;
  for (const GeneratorId i : of_component_[component_[point.face]]) {
    const double squared = (positions_[i] - at).squaredNorm();
    if (squared >= least) continue;
    if (squared > spacing_ * spacing_ || are_near(mesh_, point, all_[i], spacing_)) least = squared;
  }
  return std::sqrt(least);
}

std::optional<std::int64_t> estimate_added(const MeshSummary& mesh, std::size_t generators,
                                           const RepairHistory& history) {
  const auto [first_added, first_defects] = history.front();
  const auto [added, defects] = history.back();
  const std::int64_t least =
      mesh.boundary_loops > 0 ? 3 * std::max(mesh.components, mesh.boundary_loops) : std::int64_t{4} * mesh.components;
  const std::int64_t by_topology = added + least - std::int64_t(generators);
  const auto removed = double(first_defects) - double(defects);
  const std::int64_t by_trend =
      removed > 0 ? added + std::llround(double(defects) * double(added - first_added) / removed) : 0;
  const std::int64_t need = std::max(by_topology, by_trend);
  return need > added ? std::optional(need) : std::nullopt;
}

std::vector<SurfacePoint> propose_farthest(const Mesh& mesh, const Diagram& diagram, std::size_t count) {
  IdVector<GeneratorId, Least<VertexId>> farthest(diagram.generators.size());
  for (const VertexId v : mesh.vertices()) {
    if (diagram.vertex_label[v].valid()) farthest[diagram.vertex_label[v]].offer(-diagram.vertex_distance[v], v);
  }
  std::vector<std::pair<double, VertexId>> order;
  for (const auto& [vertex, rank] : farthest) {
    if (vertex.valid()) order.emplace_back(rank, vertex);
  }
  std::sort(order.begin(), order.end());
  AddedGenerators added(mesh, diagram.generators, count);
  for (const auto& [rank, vertex] : order) added.add(vertex_point(mesh, vertex));
  return added.take();
}

}  // namespace gvd
