#include "geodesic/reach_along_edges.hpp"

#include <functional>
#include <queue>
#include <tuple>
#include <vector>

#include "mesh/vertex_ring.hpp"

namespace gvd {

void reach_along_edges(const Mesh& mesh, WindowField& field) {
  using Offer = std::tuple<double, std::int32_t, VertexId>;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
  const auto offer_from = [&](VertexId from, VertexId to, double length) {
    if (field.label[from] >= 0 && field.label[to] < 0) offers.emplace(field.distance[from] + length, field.label[from], to);
  };
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    if (field.label[VertexId(i)] >= 0) continue;
    for_each_neighbour(mesh, VertexId(i), [&](VertexId u, HalfedgeId h) { offer_from(u, VertexId(i), mesh.length(h)); });
  }
  while (!offers.empty()) {
    const auto [distance, label, v] = offers.top();
    offers.pop();
    if (field.label[v] >= 0) continue;
    field.label[v] = label;
    field.distance[v] = distance;
    for_each_neighbour(mesh, v, [&, from = v](VertexId u, HalfedgeId h) { offer_from(from, u, mesh.length(h)); });
  }
}

}  // namespace gvd
