#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A face's part of the mesh, and its place there.
struct PartPlace {
  std::int32_t part, place;
};

/// All faces of a part of a mesh, in the order of their places, and the places of all faces of the mesh.
struct DecimatedPart {
  std::span<const FaceId> faces;
  const IdVector<FaceId, PartPlace>& places;
};

/// Collapses halfedges of a part of the mesh, without a look at the others, until this share of its faces is left or
/// none can be collapsed. Returns the faces that are left, by vertices of the mesh.
///
/// Vertices that have a face elsewhere stay, and no vertex collapses to one of them: the parts of a mesh can be
/// decimated at the same time. Faces with a vertex that has to stay count as if all were left.
/// `target`: receives the vertex that each collapsed vertex went to, which may have collapsed later. `report` is called
/// now and then with the share of the work that is done, and may throw; it may be empty.
/// Cost: O(k log k) for k faces, and 4 bytes a vertex of the mesh.
std::vector<std::array<VertexId, 3>> decimate_part(const Mesh& mesh, const DecimatedPart& part, double share,
                                                   const std::function<void(double)>& report,
                                                   IdVector<VertexId, VertexId>& target);

}  // namespace gvd
