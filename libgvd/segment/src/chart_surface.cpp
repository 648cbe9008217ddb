// Separates the regions of a cut mesh, and finds its islands.
#include "chart_surface.hpp"

#include "diagram/diagram_windows.hpp"
#include "gvd/closest_point.hpp"
#include "mesh/component_topology.hpp"

namespace gvd {

ChartSurface::ChartSurface(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut, const ChartOptions& options)
    : surface_(mesh),
      diagram_(diagram),
      cut_(cut),
      separated_(separate_regions(cut.mesh, to_regions(cut.label))),
      parallel_(options.threads, options.progress),
      field_(mesh, diagram.generators,
             {.offsets = from_zero(diagram.weights), .progress = options.progress, .threads = options.threads}) {
  islands_ = find_islands(separated_.mesh, cut.label);
}

std::vector<Island> find_islands(const Mesh& separated, const IdVector<FaceId, GeneratorId>& label) {
  const IdVector<FaceId, std::int32_t> component = compute_face_components(separated);
  const std::vector<ComponentTopology> topologies = compute_topologies(separated, component);
  std::vector<Island> islands;
  std::vector<std::int32_t> number;  // the island of each component; -1 for faces without a label
  for (const FaceId f : separated.faces()) {
    const auto c = std::size_t(component[f]);
    if (c == number.size()) {
      number.push_back(label[f].valid() ? std::int32_t(islands.size()) : -1);
      if (label[f].valid()) islands.push_back({label[f], topologies[c].euler_characteristic, {}});
    }
    if (number[c] >= 0) islands[std::size_t(number[c])].faces.push_back(f);
  }
  return islands;
}

SurfacePoint ChartSurface::point(FaceId f, int corner) const {
  const FaceId parent = cut_.parent[f];
  const Vec3& at = mesh().position(mesh().vertices(f)[std::size_t(corner)]);
  for (int i = 0; i < 3; ++i) {
    if (surface_.position(surface_.vertices(parent)[std::size_t(i)]) == at) {
      return edge_point(Mesh::halfedge(parent, i), 0);
    }
  }
  return closest_point_on_face(surface_, parent, at).point;
}

}  // namespace gvd
