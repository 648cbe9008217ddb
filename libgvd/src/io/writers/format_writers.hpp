#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

// The writers that have a file of their own, and the elements of an output that several formats share. `write_mesh` has
// checked the lengths of the arrays. Each writer throws Error{unwritable_output}.
namespace gvd::io {

/// PLY, binary or text: positions as doubles, distances as floats where these hold them, labels, and their colours.
void write_ply(std::ostream& stream, const LabelledMesh& mesh);

/// VTK PolyData in XML, arrays in Base64: faces with labels, bisectors and curves as lines.
void write_vtp(std::ostream& stream, const LabelledMesh& mesh);

/// Binary glTF 2.0: a primitive with vertices and normals of its own and a material for each region, the bisectors as
/// line segments.
/// The file can't exceed 4 GiB.
void write_glb(std::ostream& stream, const LabelledMesh& mesh);

/// Throws Error{unwritable_output} where 32-bit floats can't hold the mesh: a coordinate is too large for one, or the
/// whole mesh lies between two of them. `format` is the name of the file format, for the message. Cost: O(n).
void check_single_precision(const Mesh& mesh, std::string_view format);

/// The bytes of a NumPy file (version 1.0 of the format) before its numbers. `type`: "<f8" or "<i4".
std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape);

/// An extension without its dot, in lower case.
std::string bare_extension(std::string_view extension);

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

/// A vertex as a renderer takes it: with the normal of its faces on one side of a crease, and of one region.
struct ShadingVertex {
  VertexId vertex;
  Eigen::Vector3f normal;  ///< of length 1
};

/// The vertices of a mesh, each once for every region and every side of a crease that meet there.
struct ShadingVertices {
  std::vector<ShadingVertex> vertices;  ///< those of a region lie together, in the order in which it uses them
  std::vector<std::uint32_t> first;     ///< of each region; one more entry for the end
  IdVector<HalfedgeId, std::uint32_t> of_corner;  ///< index in `vertices` for the corner where a halfedge begins
};

/// Splits the vertices of `mesh`. `label` is that of each face, null for one region; `regions` are of these labels.
///
/// Properties: (1) a normal is the mean of the faces weighted by their angles, over both sides of a border between
/// regions, so that borders do not show; (2) faces at an angle above 40 degrees have different normals; (3) faces
/// without area have the normals of their neighbours, or the z axis where there is none.
/// Cost: O(n) time and memory.
ShadingVertices split_shading_vertices(const Mesh& mesh, const IdVector<FaceId, GeneratorId>* label,
                                       const std::vector<Region>& regions);

}  // namespace gvd::io
