#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "gvd/io/mesh_writer.hpp"

// One writer a format; `write_mesh` has checked the lengths of the arrays. Each throws Error{unwritable_output}.
namespace gvd::io {

/// PLY, binary or text: positions as doubles, distances as floats where these hold them, labels, and their colours.
void write_ply(std::ostream& stream, const LabelledMesh& mesh);

/// OBJ: a group for each region, and the bisectors as lines. `material_library` is the file name of the .mtl; empty for
/// none.
void write_obj(std::ostream& stream, const LabelledMesh& mesh, const std::string& material_library);

/// OFF, or COFF with colours of vertices and faces where there are labels.
void write_off(std::ostream& stream, const LabelledMesh& mesh);

/// Binary STL, with the colours of labelled faces in their attributes.
void write_stl(std::ostream& stream, const LabelledMesh& mesh);

/// VTK PolyData in XML, arrays in Base64: faces with labels, bisectors as lines.
void write_vtp(std::ostream& stream, const LabelledMesh& mesh);

/// Binary glTF 2.0: a primitive with vertices and normals of its own and a material for each region, the bisectors as
/// line segments.
/// The file can't exceed 4 GiB.
void write_glb(std::ostream& stream, const LabelledMesh& mesh);

/// Writes the .mtl of an OBJ: one material for each region.
void write_materials(std::ostream& stream, const LabelledMesh& mesh);

/// Throws Error{unwritable_output} where 32-bit floats can't hold the mesh: a coordinate is too large for one, or the
/// whole mesh lies between two of them. `format` is the name of the file format, for the message. Cost: O(n).
void check_single_precision(const Mesh& mesh, std::string_view format);

/// An extension without its dot, in lower case.
std::string bare_extension(std::string_view extension);

}  // namespace gvd::io
