#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A polyline in space to be written with a mesh.
struct MeshCurve {
  std::string name;              ///< name of its group in OBJ, without blanks
  std::vector<Vec3> points;      ///< two or more, mesh units; a closed curve repeats its first point at its end
  std::vector<double> distance;  ///< at each point, mesh units
};

/// A further whole number for each face, such as the number of its region.
struct FaceNumbers {
  std::string name;
  IdVector<FaceId, std::int32_t> values;
};

/// A mesh and arrays over its elements to be written to a file; null arrays are not written. `LabelledMesh{mesh}` is a
/// plain mesh.
/// A LabelledMesh owns nothing: everything that it points to must outlive it.
struct LabelledMesh {
  const Mesh& mesh;
  const IdVector<FaceId, GeneratorId>* face_label = nullptr;      ///< invalid ids are written as -1, in grey
  const IdVector<FaceId, FaceId>* face_parent = nullptr;          ///< the face of the input that a face is a piece of
  const IdVector<VertexId, GeneratorId>* vertex_label = nullptr;  ///< invalid ids are written as -1
  const IdVector<VertexId, double>* vertex_distance = nullptr;    ///< mesh units; infinity where no generator reaches
  const Diagram* diagram = nullptr;  ///< its bisectors become polylines, and cells that meet have different colours
  /// The mesh to which the diagram's surface points refer; null if that is `mesh` itself. It is set if `mesh` was cut
  /// along the bisectors, or if its regions were separated for the diagram.
  const Mesh* diagram_mesh = nullptr;
  const std::vector<MeshCurve>* curves = nullptr;  ///< for Content::curves, after the bisectors
  /// Further properties of vertices and faces, for Content::properties, with a value for each element; may be null.
  const std::vector<MeshProperty>* properties = nullptr;
  const std::vector<FaceNumbers>* face_numbers = nullptr;  ///< for Content::face_numbers
  /// Texture coordinates of the faces' corners, and materials, for the formats that carry them. A face with a
  /// coordinate that is not finite has none. May be null.
  const Appearance* appearance = nullptr;
  bool ascii_ply = false;         ///< PLY as text instead of binary
  bool no_bisectors = false;      ///< leave out the bisectors of the diagram
  bool region_materials = false;  ///< in OBJ, give each region its own material even if faces have materials

  const Mesh& surface() const { return diagram_mesh != nullptr ? *diagram_mesh : mesh; }
  bool has_texture() const { return appearance != nullptr && !appearance->texture.empty(); }
  /// Whether OBJ names the materials of the faces.
  bool names_materials() const { return appearance != nullptr && !appearance->material.empty() && !region_materials; }
};

/// A mesh with the labels and distances of its diagram, and with `faces` as the labels of its faces.
inline LabelledMesh label_mesh(const Mesh& mesh, const Diagram& diagram, const IdVector<FaceId, GeneratorId>& faces) {
  return {mesh, &faces, nullptr, &diagram.vertex_label, &diagram.vertex_distance, &diagram};
}

/// The loss of a mesh's positions when they are rounded to the numbers of a file format.
struct PositionLoss {
  double farthest_move = 0;          ///< the largest distance by which rounding moves a vertex, mesh units
  std::int64_t collapsed_faces = 0;  ///< faces with area that have none after rounding
  bool is_notable = false;  ///< rounding moves corners by more than a 64th of the edges, on a 1000th of the area
};

}  // namespace gvd
