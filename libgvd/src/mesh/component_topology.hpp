#pragma once

#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The topology of a connected part of a mesh.
struct ComponentTopology {
  std::int32_t euler_characteristic = 0;  ///< vertices - edges + faces: 1 for a disc
  std::int32_t boundary_loops = 0;
  bool operator==(const ComponentTopology&) const = default;
};

/// Computes the topology of each component. `component` is the result of `compute_face_components(mesh)`. Cost: O(n).
std::vector<ComponentTopology> compute_topologies(const Mesh& mesh, const IdVector<FaceId, std::int32_t>& component);

/// Twice the genus (the number of handles), summed over all components. Source: Euler's formula.
constexpr std::int32_t twice_genus(std::int32_t components, std::int32_t boundary_loops,
                                   std::int32_t euler_characteristic) {
  return 2 * components - boundary_loops - euler_characteristic;
}

/// The fewest vertices of a mesh with this topology: four for a sphere, three for a disc, six for an annulus, seven for
/// a torus. With more than three handles it is an upper bound.
constexpr std::int64_t least_vertices(const ComponentTopology& topology) {
  const std::int64_t handles = twice_genus(1, topology.boundary_loops, topology.euler_characteristic) / 2;
  return (topology.boundary_loops == 0 ? 4 : 3 * std::int64_t{topology.boundary_loops}) + 3 * handles;
}

}  // namespace gvd
