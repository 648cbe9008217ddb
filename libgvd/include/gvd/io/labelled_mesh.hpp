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
  std::string name;              ///< of its group in OBJ, without blanks
  std::vector<Vec3> points;      ///< two or more, mesh units; a closed one repeats its first point at its end
  std::vector<double> distance;  ///< at each point, mesh units
};

/// A further whole number of each face, such as that of a region.
struct FaceNumbers {
  std::string name;
  IdVector<FaceId, std::int32_t> values;
};

/// A mesh and arrays over its elements; what is null is not written. `LabelledMesh{mesh}` is a plain mesh.
/// A LabelledMesh owns nothing: everything that it points to must outlive it.
struct LabelledMesh {
  const Mesh& mesh;
  const IdVector<FaceId, GeneratorId>* face_label = nullptr;      ///< invalid ids are written as -1, in grey
  const IdVector<FaceId, FaceId>* face_parent = nullptr;          ///< the face of the input that a face is a piece of
  const IdVector<VertexId, GeneratorId>* vertex_label = nullptr;  ///< invalid ids are written as -1
  const IdVector<VertexId, double>* vertex_distance = nullptr;    ///< mesh units; infinity where no generator reaches
  const Diagram* diagram = nullptr;  ///< its bisectors become polylines, and cells that meet have different colours
  /// The mesh of the diagram's surface points. Null: `mesh` itself. Set where `mesh` was cut along the bisectors, or
  /// where its regions were separated for the diagram.
  const Mesh* diagram_mesh = nullptr;
  const std::vector<MeshCurve>* curves = nullptr;  ///< for Content::curves, behind the bisectors
  /// Further properties of vertices and faces, for Content::properties; a value for each element. Null: none.
  const std::vector<MeshProperty>* properties = nullptr;
  const std::vector<FaceNumbers>* face_numbers = nullptr;  ///< for Content::face_numbers
  /// Texture coordinates of the faces' corners, and materials, for the formats that carry them. A face with a
  /// coordinate that is not finite has none. Null: none.
  const Appearance* appearance = nullptr;
  bool ascii_ply = false;         ///< PLY as text instead of binary
  bool no_bisectors = false;      ///< leave those of the diagram out
  bool region_materials = false;  ///< in OBJ, each region has a material of its own also where faces have materials

  const Mesh& surface() const { return diagram_mesh != nullptr ? *diagram_mesh : mesh; }
  bool has_texture() const { return appearance != nullptr && !appearance->texture.empty(); }
  /// Whether OBJ names the materials of the faces.
  bool names_materials() const { return appearance != nullptr && !appearance->material.empty() && !region_materials; }
};

/// A mesh with the labels and distances of its diagram, and with these labels of its faces.
inline LabelledMesh label_mesh(const Mesh& mesh, const Diagram& diagram, const IdVector<FaceId, GeneratorId>& faces) {
  return {mesh, &faces, nullptr, &diagram.vertex_label, &diagram.vertex_distance, &diagram};
}

/// What the numbers of a file format do to the positions of a mesh.
struct PositionLoss {
  double farthest_move = 0;          ///< how far a vertex is moved by rounding, mesh units
  std::int64_t collapsed_faces = 0;  ///< faces with area that have none afterwards
  bool is_notable = false;  ///< rounding moves corners by more than a 64th of the edges, on a 1000th of the area
};

}  // namespace gvd
