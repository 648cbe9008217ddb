#pragma once

#include <span>

#include "gvd/ids.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The generators that differ between two working meshes of the same input, because they were moved, added, removed or
/// renumbered. Every other generator has the same number and the same point in both meshes.
struct ChangedGenerators {
  std::vector<GeneratorId> before, after;  ///< their numbers in each mesh
  std::vector<SurfacePoint> points;        ///< all their points, old and new, on the input
};

/// The faces and vertices that two working meshes of the same input have in common. If no changed generator lies in a
/// face of the input, both meshes split the face in the same way, so that its parts and the vertices inside it
/// correspond in their order.
struct CommonElements {
  /// The same face in the other mesh; invalid if the two meshes split its parent differently.
  IdVector<FaceId, FaceId> before, after;
  IdVector<VertexId, VertexId> vertex_before;  ///< for each vertex after; invalid for the vertex of a changed generator
  std::vector<FaceId> only_before, only_after;  ///< faces without a counterpart, ascending
};

/// The change from one set of generators to another. Refers to objects that the caller owns.
struct GeneratorChange {
  const WorkingMesh &before, &after;
  const CommonElements& common;
  const ChangedGenerators& changed;
};

/// Finds the common faces and vertices. Cost: O(n).
CommonElements find_common_elements(const WorkingMesh& before, const WorkingMesh& after,
                                    const ChangedGenerators& changed);

}  // namespace gvd
