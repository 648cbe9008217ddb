#include "diagram/paper/rough_segments.hpp"

#include <cstdint>
#include <utility>

namespace gvd {
namespace {

void append_midpoint(const Mesh& mesh, EdgeId e, const NearestLabels& labels, std::vector<Crossing>& crossings) {
  const HalfedgeId h = mesh.halfedge(e);
  const GeneratorId from = labels.label[mesh.from(h)], to = labels.label[mesh.to(h)];
  if (from != to) crossings.push_back({e, 0.5, from, to});
}

}  // namespace

Crossings find_rough_segments(const Mesh& mesh, const NearestLabels& labels) {
  std::vector<Crossing> crossings;
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) append_midpoint(mesh, EdgeId(e), labels, crossings);
  return {mesh.edge_count(), std::move(crossings)};
}

void cross_at_midpoints(const Mesh& mesh, const std::vector<EdgeId>& edges, const NearestLabels& labels,
                        Crossings& crossings) {
  std::vector<Crossing> midpoints;
  for (const EdgeId e : edges) append_midpoint(mesh, e, labels, midpoints);
  crossings.replace(edges, midpoints);
}

}  // namespace gvd
