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

// The writers of the formats, and the elements of an output that several formats share. `write_mesh` has already
// checked the lengths of the arrays. Each writer throws Error{unwritable_output}. Writers of formats that hold only
// labels, distances or a diagram throw Error{invalid_option} if the mesh has none.
namespace gvd::io {

/// A mesh to be written, with the colours of its labels.
struct ColoredMesh : LabelledMesh {
  explicit ColoredMesh(const LabelledMesh& labelled) : LabelledMesh(labelled), colors(region_colors(labelled)) {}
  Rgb color(GeneratorId label) const { return label.valid() ? colors[label.index()] : kUnlabelledColor; }

  std::vector<Rgb> colors;
};

/// Writes PLY, binary or text: positions as doubles, distances as floats if these can hold them, labels, and the
/// labels' colours.
void write_ply(std::ostream& stream, const ColoredMesh& mesh);

/// Writes OBJ: a group for each region, texture coordinates, and the bisectors and curves as lines. The second function
/// also gives each region a material; `material_library` is the name of the file with these materials.
void write_obj(std::ostream& stream, const ColoredMesh& mesh);
void write_obj_with_library(std::ostream& stream, const LabelledMesh& mesh, const std::string& material_library);

/// Writes the .mtl of an OBJ, with one material for each region.
void write_materials(std::ostream& stream, const ColoredMesh& mesh);

/// Writes OFF without colours; and COFF, with colours of vertices and faces if these have labels.
void write_off(std::ostream& stream, const ColoredMesh& mesh);
void write_coff(std::ostream& stream, const ColoredMesh& mesh);

/// Writes binary STL, with the colours of labelled faces in their attributes.
void write_stl(std::ostream& stream, const ColoredMesh& mesh);

/// Writes VTK PolyData in XML with arrays in Base64: faces with labels, and bisectors and curves as lines.
void write_vtp(std::ostream& stream, const ColoredMesh& mesh);

/// Writes VTK UnstructuredGrid in XML, with the same arrays. Faces come first, and each segment of a line is a cell.
void write_vtu(std::ostream& stream, const ColoredMesh& mesh);

/// Writes binary glTF 2.0: the surface as one primitive, with normals, colours, labels and texture coordinates of
/// vertices, and the bisectors as line segments. The format limits a file to 4 GiB.
void write_glb(std::ostream& stream, const ColoredMesh& mesh);

/// Write GIFTI, with arrays in Base64: positions as 32-bit floats and triangles; or the labels of vertices, with a
/// table of their names and colours; or the distances of vertices.
void write_gifti_surface(std::ostream& stream, const ColoredMesh& mesh);
void write_gifti_labels(std::ostream& stream, const ColoredMesh& mesh);
void write_gifti_distances(std::ostream& stream, const ColoredMesh& mesh);

/// Write FreeSurfer's formats: surfaces of triangles, with 32-bit floats; annotations of version 2, which have a colour
/// for each vertex and a table of the regions; and distances of vertices as FreeSurfer's values.
void write_freesurfer_surface(std::ostream& stream, const ColoredMesh& mesh);
void write_annotation(std::ostream& stream, const ColoredMesh& mesh);
void write_freesurfer_distances(std::ostream& stream, const ColoredMesh& mesh);

/// Writes the diagram of the mesh as `gvd-diagram/1`.
void write_diagram(std::ostream& stream, const ColoredMesh& mesh);

/// A label of vertices as GIFTI and FreeSurfer store it. Numbers begin at 1; 0 stands for no label.
struct NumberedLabel {
  std::int32_t number;
  std::string name;
  Rgb color;
};

inline std::int32_t label_number(GeneratorId label) { return label.valid() ? label.value() + 1 : 0; }

/// The table of a mesh's labels of vertices: first the entry for no label, which both formats call ???, then all labels
/// of the diagram or of the vertices. Throws Error{invalid_option} if the vertices have no labels; `format` is for the
/// message.
std::vector<NumberedLabel> number_labels(const ColoredMesh& mesh, std::string_view format);

/// The distances of the vertices, for formats that hold nothing else. Throws Error{invalid_option} if there are none;
/// `format` is for the message.
DistanceTable require_distances(const ColoredMesh& mesh, std::string_view format);

/// Says why 32-bit floats can't hold the mesh: a coordinate is too large for a float, or the whole mesh, relative to
/// `origin`, fits between two neighbouring floats. Empty if floats can hold it. Cost: O(n).
std::string why_not_floats(const Mesh& mesh, const Vec3& origin);

/// Measures how rounding to 32-bit floats changes the positions of a mesh, relative to `origin`. Cost: O(n).
PositionLoss measure_float_loss(const Mesh& mesh, const Vec3& origin);

/// The point that the positions of a GLB are relative to. It is 0 unless the mesh is so far from the origin that floats
/// would damage it; then it is a point near the mesh's centre whose coordinates are floats. Cost: O(n).
Vec3 glb_translation(const Mesh& mesh);

/// The largest coordinate relative to `origin`, without sign. Cost: O(n).
double largest_local_coordinate(const Mesh& mesh, const Vec3& origin);

/// Whether texture coordinates fit into 32-bit floats, which GLB uses for them, and PLY where they suffice.
inline bool fits_floats(const Uv& uv) {
  const auto fits = [](double x) { return std::abs(x) <= double(std::numeric_limits<float>::max()); };
  return fits(uv[0]) && fits(uv[1]);
}

/// Converts a colour of sRGB (IEC 61966-2-1) to linear factors of light, as glTF prescribes and as Blender interprets
/// `Kd`. Rounds to four digits, which suffice for 8 bits, so that the last bit of pow does not matter.
std::array<double, 3> to_linear(const Rgb& color);

/// The bytes of a NumPy file (version 1.0 of the format) before its numbers. `type`: "<f8" or "<i4".
std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape);

/// An extension without its dot, in lower case.
inline std::string bare_extension(std::string_view extension) {
  return to_lower(extension.substr(extension.starts_with('.') ? 1 : 0));
}

/// The faces with one label.
struct Region {
  GeneratorId label;
  std::vector<FaceId> faces;  ///< ascending
};

/// The regions with at least one face, by label. The faces without a label come last. If the mesh has no labels, all
/// faces are one region.
/// Cost: O(n log r) for n faces and r regions.
std::vector<Region> collect_regions(const LabelledMesh& mesh);

/// The name of a region in formats that name groups or materials.
std::string region_name(GeneratorId label);

/// A bisector or a curve as a polyline in space.
struct OutputLine {
  GeneratorId left;          ///< invalid for a curve
  GeneratorId right;         ///< invalid for a curve
  std::string group;         ///< its name in OBJ
  std::vector<Vec3> points;  ///< two or more; a closed line repeats its first point at its end
  /// At each point, interpolated linearly in its face; infinity where no generator reaches.
  std::vector<double> distance;
};

/// The bisectors of the diagram in its order, except bisectors of a single point, then the curves. Cost: O(n).
std::vector<OutputLine> collect_lines(const LabelledMesh& mesh);

/// A vertex for renderers, which belongs to the faces on one side of a crease, in one region, and on one side of a seam
/// of the texture.
struct ShadingVertex {
  VertexId vertex;
  Eigen::Vector3f normal;  ///< of length 1
  GeneratorId label;       ///< of its region
  Uv texture{};            ///< of its corners; 0 if its faces have none
};

/// The vertices of a mesh, each once for every region, every side of a crease and every side of a seam that meet there.
struct ShadingVertices {
  std::vector<ShadingVertex> vertices;            ///< in the order in which the faces use them
  IdVector<HalfedgeId, std::uint32_t> of_corner;  ///< for the corner where a halfedge begins: the index in `vertices`
};

/// Splits the vertices of a mesh where the normals, the labels of faces or the texture coordinates differ.
///
/// Properties: (1) a normal is the mean of the faces' normals, weighted by their angles, over both sides of a border
/// between regions, so that shading does not reveal borders; (2) faces at an angle above 40 degrees have different
/// normals; (3) faces without area get the normals of their neighbours, or the z axis if there are none.
/// Cost: O(n) time and memory.
ShadingVertices split_shading_vertices(const LabelledMesh& mesh);

}  // namespace gvd::io
