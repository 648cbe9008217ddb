#pragma once

#include <span>

#include "gvd/ids.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Generators that differ between two working meshes of one input: moved, added, removed, or with another number. All
/// others have the same number and the same point in both.
struct ChangedGenerators {
  std::vector<GeneratorId> before, after;  ///< by their numbers in either mesh
  std::vector<SurfacePoint> points;        ///< all their points, in the input
};

/// The faces and vertices that two working meshes of one input have in common. A face of the input that no changed
/// generator splits is split by both in the same way, so that its parts, and its own vertices, correspond in their
/// order.
struct CommonElements {
  IdVector<FaceId, FaceId> before, after;       ///< of each face in the other mesh; invalid for a part of another split
  IdVector<VertexId, VertexId> vertex_before;   ///< of each vertex after; invalid for a changed generator's own
  std::vector<FaceId> only_before, only_after;  ///< faces of other splits, ascending
};

/// The step from one set of generators to another one. Refers to what the caller holds.
struct GeneratorChange {
  const WorkingMesh &before, &after;
  const CommonElements& common;
  const ChangedGenerators& changed;
};

/// Cost: O(n).
CommonElements find_common_elements(const WorkingMesh& before, const WorkingMesh& after,
                                    const ChangedGenerators& changed);

}  // namespace gvd
