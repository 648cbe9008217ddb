#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The file formats of a mesh or diagram that is written. docs/guide/formats.md says what each one carries.
enum class OutputFormat {
  ply,
  obj,
  off,
  coff,
  stl,
  vtp,
  vtu,
  glb,
  json,
  gifti_surface,
  gifti_labels,  ///< labels of vertices alone
  gifti_values,  ///< distances of vertices alone
  freesurfer_surface,
  freesurfer_labels,  ///< as an annotation
  freesurfer_values,
};
inline const Choices<OutputFormat> kOutputFormatNames{{"ply", OutputFormat::ply},
                                                      {"obj", OutputFormat::obj},
                                                      {"off", OutputFormat::off},
                                                      {"coff", OutputFormat::coff},
                                                      {"stl", OutputFormat::stl},
                                                      {"vtp", OutputFormat::vtp},
                                                      {"vtu", OutputFormat::vtu},
                                                      {"glb", OutputFormat::glb},
                                                      {"json", OutputFormat::json},
                                                      {"surf.gii", OutputFormat::gifti_surface},
                                                      {"label.gii", OutputFormat::gifti_labels},
                                                      {"shape.gii", OutputFormat::gifti_values},
                                                      {"fs", OutputFormat::freesurfer_surface},
                                                      {"annot", OutputFormat::freesurfer_labels},
                                                      {"curv", OutputFormat::freesurfer_values}};

/// The extension that chooses the format of a file, in lower case and without its dot. GIFTI has three: label.gii,
/// shape.gii, also for .func.gii, and surf.gii for any other name that ends in .gii.
std::string format_extension(const std::filesystem::path& path);

/// The format of an extension, with or without its dot, in upper or lower case: surf.gii, label.gii and shape.gii are
/// GIFTI's; fs, annot and curv are FreeSurfer's.
std::optional<OutputFormat> parse_output_format(std::string_view extension);

/// The format that a file's name asks for. Throws Error{invalid_option} that lists the known extensions.
OutputFormat output_format(const std::filesystem::path& path);

/// Throws Error{unwritable_output} where the format can't hold the coordinates of the mesh, as `write_mesh` does: call
/// it before long work. A result with the same bounding box fits as well. Cost: O(n).
void check_format(const Mesh& mesh, OutputFormat format);

/// What the numbers of a file format do to the positions of a mesh.
struct PositionLoss {
  double farthest_move = 0;          ///< how far a vertex is moved by rounding, mesh units
  std::int64_t collapsed_faces = 0;  ///< faces with area that have none afterwards
  bool is_notable = false;  ///< rounding moves corners by more than a 64th of the edges, on a 1000th of the area
};

/// The loss of STL, GLB, GIFTI and FreeSurfer's surfaces, which have 32-bit floats; none for other formats, which keep
/// doubles. Positions of a GLB are relative to a point near the mesh if that is far from the origin, so that they lose
/// little. Cost: O(n).
PositionLoss measure_position_loss(const Mesh& mesh, OutputFormat format);

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
  const std::vector<MeshCurve>* curves = nullptr;  ///< for OBJ, VTP, VTU and GLB, behind the bisectors
  /// Further properties of vertices and faces, for PLY only; a value for each element. Null: none.
  const std::vector<MeshProperty>* properties = nullptr;
  const std::vector<FaceNumbers>* face_numbers = nullptr;  ///< for PLY, VTP and VTU
  /// Texture coordinates of the faces' corners, for PLY, OBJ and GLB, and materials, for OBJ. A face with a coordinate
  /// that is not finite has none. Null: none.
  const Appearance* appearance = nullptr;
  bool ascii_ply = false;         ///< PLY as text instead of binary
  bool no_bisectors = false;      ///< leave those of the diagram out of OBJ, VTP, VTU and GLB
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

/// Writes the mesh in one format. The stream is flushed and checked.
///
/// In OBJ the stream holds the geometry and the groups, and materials where the faces have them.
/// Distances in PLY are floats, or doubles where a float can't hold one of them.
/// Throws Error{precondition} where the length of an array is not the number of elements.
/// Throws Error{invalid_option} for JSON without a diagram, and for formats of labels or distances without them.
/// Throws Error{unwritable_output} where the stream fails or the format can't hold the mesh: STL, GLB, GIFTI and
/// FreeSurfer's have 32-bit floats, GLB at most 4 GiB.
/// Cost: O(n) time; memory O(n) for the order of the faces by label, O(1) without labels.
void write_mesh(std::ostream& out, const LabelledMesh& mesh, OutputFormat format);

/// Writes a complete file or none, in the format of its extension; for OBJ with materials of regions also the .mtl
/// beside it.
/// Throws what `write_mesh` to a stream and `write_file` throw.
void write_mesh(const std::filesystem::path& path, const LabelledMesh& mesh, const Progress& progress = {});

}  // namespace gvd
