#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/io/labelled_mesh.hpp"
#include "gvd/mesh.hpp"
#include "gvd/text.hpp"
#include "gvd/vec.hpp"

// The writers of the formats, and the elements of an output that several formats share. `write_mesh` has checked the
// lengths of the arrays. Each writer throws Error{unwritable_output}, and those of labels, distances or diagrams alone
// throw Error{invalid_option} where the mesh has none.
namespace gvd::io {

/// A mesh to be written, with the colours of its labels.
struct ColoredMesh : LabelledMesh {
  explicit ColoredMesh(const LabelledMesh& labelled) : LabelledMesh(labelled), colors(region_colors(labelled)) {}
  Rgb color(GeneratorId label) const { return label.valid() ? colors[label.index()] : kUnlabelledColor; }

  std::vector<Rgb> colors;
};

/// PLY, binary or text: positions as doubles, distances as floats where these hold them, labels, and their colours.
void write_ply(std::ostream& stream, const ColoredMesh& mesh);

/// OBJ: a group for each region, its texture coordinates and materials, and the bisectors and curves as lines. With the
/// library of the regions' materials, where it has one: `material_library` is the name of its file.
void write_obj(std::ostream& stream, const ColoredMesh& mesh);
void write_obj_with_library(std::ostream& stream, const LabelledMesh& mesh, const std::string& material_library);

/// The .mtl of an OBJ: one material for each region.
void write_materials(std::ostream& stream, const ColoredMesh& mesh);

/// OFF; and OFF with colours of vertices and faces where there are labels.
void write_off(std::ostream& stream, const ColoredMesh& mesh);
void write_coff(std::ostream& stream, const ColoredMesh& mesh);

/// Binary STL, with the colours of labelled faces in their attributes.
void write_stl(std::ostream& stream, const ColoredMesh& mesh);

/// VTK PolyData in XML, arrays in Base64: faces with labels, bisectors and curves as lines.
void write_vtp(std::ostream& stream, const ColoredMesh& mesh);

/// VTK UnstructuredGrid in XML: the same arrays, with faces first, and each segment of a line as a cell.
void write_vtu(std::ostream& stream, const ColoredMesh& mesh);

/// Binary glTF 2.0: the surface as one primitive, with normals, colours, labels and texture coordinates of vertices,
/// and the bisectors as line segments. The file can't exceed 4 GiB.
void write_glb(std::ostream& stream, const ColoredMesh& mesh);

/// GIFTI, arrays in Base64: positions as 32-bit floats and triangles; or the labels of vertices, with a table of their
/// names and colours; or their distances.
void write_gifti_surface(std::ostream& stream, const ColoredMesh& mesh);
void write_gifti_labels(std::ostream& stream, const ColoredMesh& mesh);
void write_gifti_distances(std::ostream& stream, const ColoredMesh& mesh);

/// FreeSurfer's surfaces of triangles, with 32-bit floats; its annotations, version 2: a colour for each vertex, and a
/// table of the regions; and distances of vertices as its values.
void write_freesurfer_surface(std::ostream& stream, const ColoredMesh& mesh);
void write_annotation(std::ostream& stream, const ColoredMesh& mesh);
void write_freesurfer_distances(std::ostream& stream, const ColoredMesh& mesh);

/// The diagram of the mesh as `gvd-diagram/1`.
void write_diagram(std::ostream& stream, const ColoredMesh& mesh);

/// A label of vertices as GIFTI and FreeSurfer have it: its number, from 1; 0 stands for no label.
struct NumberedLabel {
  std::int32_t number;
  std::string name;
  Rgb color;
};

inline std::int32_t label_number(GeneratorId label) { return label.valid() ? label.value() + 1 : 0; }

/// The table of a mesh's labels of vertices: no label, which both formats call ???, and then all that the diagram or
/// the vertices have. Throws Error{invalid_option} where the vertices have no labels; `format` is for the message.
std::vector<NumberedLabel> number_labels(const ColoredMesh& mesh, std::string_view format);

/// The distances of the vertices, for formats that hold nothing else. Throws Error{invalid_option} where there are
/// none; `format` is for the message.
DistanceTable require_distances(const ColoredMesh& mesh, std::string_view format);

/// Why 32-bit floats can't hold the mesh: a coordinate is too large for one, or the whole mesh lies between two of
/// them, relative to `origin`. Empty where they can. Cost: O(n).
std::string why_not_floats(const Mesh& mesh, const Vec3& origin);

/// The effect of 32-bit floats on the positions of a mesh, relative to `origin`. Cost: O(n).
PositionLoss measure_float_loss(const Mesh& mesh, const Vec3& origin);

/// The point that the positions of a GLB are relative to: 0, or a point with floats as coordinates near the centre of a
/// mesh that is so far from the origin that floats would damage it. Cost: O(n).
Vec3 glb_translation(const Mesh& mesh);

/// The largest coordinate relative to `origin`, without sign. Cost: O(n).
double largest_local_coordinate(const Mesh& mesh, const Vec3& origin);

/// Whether texture coordinates are numbers that 32-bit floats can hold, as PLY and GLB have them.
inline bool fits_floats(const Uv& uv) {
  const auto fits = [](double x) { return std::abs(x) <= double(std::numeric_limits<float>::max()); };
  return fits(uv[0]) && fits(uv[1]);
}

/// A colour of sRGB (IEC 61966-2-1) as linear factors of light, which Blender takes `Kd` for and glTF prescribes.
/// Rounded to four digits, which 8 bits need, so that the last bit of pow does not matter.
std::array<double, 3> to_linear(const Rgb& color);

/// The bytes of a NumPy file (version 1.0 of the format) before its numbers. `type`: "<f8" or "<i4".
std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape);

/// An extension without its dot, in lower case.
inline std::string bare_extension(std::string_view extension) {
  return to_lower(extension.substr(extension.starts_with('.') ? 1 : 0));
}

/// The faces of one label.
struct Region {
  GeneratorId label;
  std::vector<FaceId> faces;  ///< ascending
};

/// The regions that own a face, by label; the faces without a label come last. Without labels one region of all faces.
/// Cost: O(n log r) for n faces and r regions.
std::vector<Region> collect_regions(const LabelledMesh& mesh);

/// The name of a region in formats that name groups or materials.
std::string region_name(GeneratorId label);

/// A bisector or a curve as a polyline in space.
struct OutputLine {
  GeneratorId left;              ///< invalid for a curve
  GeneratorId right;             ///< invalid for a curve
  std::string group;             ///< its name in OBJ
  std::vector<Vec3> points;      ///< two or more; a closed line repeats its first point at its end
  std::vector<double> distance;  ///< at each point, linear in its face; infinity where no generator reaches
};

/// The bisectors of the diagram in its order, without those of a single point, then the curves. Cost: O(n).
std::vector<OutputLine> collect_lines(const LabelledMesh& mesh);

/// A vertex as a renderer takes it: with the normal of its faces on one side of a crease, of one region, and on one
/// side of a seam of the texture.
struct ShadingVertex {
  VertexId vertex;
  Eigen::Vector3f normal;  ///< of length 1
  GeneratorId label;       ///< of its region
  Uv texture{};            ///< of its corners; 0 where its faces have none
};

/// The vertices of a mesh, each once for every region, every side of a crease and every side of a seam that meet there.
struct ShadingVertices {
  std::vector<ShadingVertex> vertices;            ///< in the order in which the faces use them
  IdVector<HalfedgeId, std::uint32_t> of_corner;  ///< index in `vertices` for the corner where a halfedge begins
};

/// Splits the vertices of a mesh where the normals, the labels of faces or the texture coordinates differ.
///
/// Properties: (1) a normal is the mean of the faces weighted by their angles, over both sides of a border between
/// regions, so that borders do not show; (2) faces at an angle above 40 degrees have different normals; (3) faces
/// without area have the normals of their neighbours, or the z axis where there is none.
/// Cost: O(n) time and memory.
ShadingVertices split_shading_vertices(const LabelledMesh& mesh);

}  // namespace gvd::io
