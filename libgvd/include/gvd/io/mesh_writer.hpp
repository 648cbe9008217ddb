#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "gvd/io/format.hpp"
#include "gvd/io/labelled_mesh.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// The extension that determines the format of a file, in lower case and without its dot. This is the first extension
/// of the format, such as shape.gii for a name that ends in .func.gii, or the name's own extension if no format has it.
std::string format_extension(const std::filesystem::path& path);

/// The format that `write_mesh` writes for an extension, which may be in upper or lower case, with or without its dot.
/// Nothing for any other text.
std::optional<MeshFormat> parse_output_format(std::string_view extension);

/// The format that a file's name asks for. Throws Error{invalid_option}, which lists the known extensions, if there is
/// none.
MeshFormat output_format(const std::filesystem::path& path);

/// The path of the file with the regions' materials that belongs to a file with this name; nothing if its format has
/// none.
std::optional<std::filesystem::path> materials_file(const std::filesystem::path& path);

/// Throws Error{unwritable_output} if the format can't hold the coordinates of the mesh, as `write_mesh` would. Call it
/// before long work; a result with the same bounding box fits as well. Cost: O(n).
void check_format(const Mesh& mesh, MeshFormat format);

/// Measures what a surface loses in a format with 32-bit floats. Formats that keep doubles lose nothing, and a GLB
/// loses little: its positions are relative to a point near the mesh if the mesh is far from the origin. Cost: O(n).
PositionLoss measure_position_loss(const Mesh& mesh, MeshFormat format);

/// Writes the mesh in one format. The stream is flushed and checked for errors.
///
/// In OBJ, the stream holds the geometry, the groups and, if the faces have them, the names of materials.
/// Distances in PLY are floats, or doubles if a float can't hold one of them.
/// Throws Error{precondition} if the length of an array is not the number of elements.
/// Throws Error{invalid_option} for JSON without a diagram, and for formats of labels or distances without them.
/// Throws Error{unwritable_output} if the stream fails or the format can't hold the mesh: STL, GLB, GIFTI and
/// FreeSurfer's formats have 32-bit floats, and GLB has at most 4 GiB.
/// Cost: O(n) time; memory O(n) for the order of the faces by label, O(1) without labels.
void write_mesh(std::ostream& out, const LabelledMesh& mesh, MeshFormat format);

/// Writes a complete file or none, in the format of its extension. For an OBJ with materials of regions, it also writes
/// the .mtl beside it.
/// Throws what `write_mesh` to a stream and `write_file` throw.
void write_mesh(const std::filesystem::path& path, const LabelledMesh& mesh, const Progress& progress = {});

}  // namespace gvd
