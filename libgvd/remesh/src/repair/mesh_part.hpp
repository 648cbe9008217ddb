#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A flag for each cell of a diagram.
using CellFlags = IdVector<GeneratorId, char>;

/// The cells that are at most `rings` bisectors away from the given ones. Cost: O(cells).
CellFlags grow_rings(const Diagram& diagram, const std::vector<GeneratorId>& cells, int rings);

/// The faces of a mesh that meet some cells of a diagram, as a mesh of their own.
///
/// Faces that meet at a vertex only, without a fan of such faces between them, get a vertex each. No shortest path that
/// stays in the cells passes such a vertex. Why: if a cell holds a vertex, all faces round it belong to the part.
class MeshPart {
 public:
  /// `in_part`: which cells. The diagram is one of the mesh. Cost: O(n).
  MeshPart(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part);

  const Mesh& mesh() const { return part_; }
  /// The number of its faces.
  std::size_t size() const { return whole_face_.size(); }

  /// Nothing for a point of a face outside of the part.
  std::optional<SurfacePoint> to_part(const SurfacePoint& point) const;
  SurfacePoint to_whole(const SurfacePoint& point) const { return {whole_face_[point.face], point.bary}; }

  /// Whether a face of the part meets other cells too, or an edge that is on the boundary of the part alone.
  bool is_fringe(FaceId of_part) const { return fringe_[of_part] != 0; }

 private:
  void choose_faces(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part);
  void build(const Mesh& mesh);
  void number_fan(const Mesh& mesh, HalfedgeId outgoing, VertexId v, std::vector<std::array<VertexId, 3>>& faces) const;

  Mesh part_;
  IdVector<FaceId, FaceId> whole_face_;  // of each face of the part
  IdVector<FaceId, FaceId> part_face_;   // of each face of the whole mesh; invalid outside of the part
  IdVector<FaceId, char> fringe_;        // of each face of the part
};

}  // namespace gvd
