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

/// The extension that chooses the format of a file, in lower case and without its dot: the first one of the format, as
/// shape.gii for a name that ends in .func.gii, or that of the name, where no format has it.
std::string format_extension(const std::filesystem::path& path);

/// The format of an extension, with or without its dot, in upper or lower case, that `write_mesh` writes.
std::optional<MeshFormat> parse_output_format(std::string_view extension);

/// The format that a file's name asks for. Throws Error{invalid_option} that lists the known extensions.
MeshFormat output_format(const std::filesystem::path& path);

/// The file of materials of regions beside a file with this name; nothing where its format has none.
std::optional<std::filesystem::path> materials_file(const std::filesystem::path& path);

/// Throws Error{unwritable_output} where the format can't hold the coordinates of the mesh, as `write_mesh` does: call
/// it before long work. A result with the same bounding box fits as well. Cost: O(n).
void check_format(const Mesh& mesh, MeshFormat format);

/// The loss of surfaces in formats with 32-bit floats; none in formats that keep doubles. Positions of a GLB are
/// relative to a point near the mesh if that is far from the origin, so that they lose little. Cost: O(n).
PositionLoss measure_position_loss(const Mesh& mesh, MeshFormat format);

/// Writes the mesh in one format. The stream is flushed and checked.
///
/// In OBJ the stream holds the geometry and the groups, and materials where the faces have them.
/// Distances in PLY are floats, or doubles where a float can't hold one of them.
/// Throws Error{precondition} where the length of an array is not the number of elements.
/// Throws Error{invalid_option} for JSON without a diagram, and for formats of labels or distances without them.
/// Throws Error{unwritable_output} where the stream fails or the format can't hold the mesh: STL, GLB, GIFTI and
/// FreeSurfer's have 32-bit floats, GLB at most 4 GiB.
/// Cost: O(n) time; memory O(n) for the order of the faces by label, O(1) without labels.
void write_mesh(std::ostream& out, const LabelledMesh& mesh, MeshFormat format);

/// Writes a complete file or none, in the format of its extension; for OBJ with materials of regions also the .mtl
/// beside it.
/// Throws what `write_mesh` to a stream and `write_file` throw.
void write_mesh(const std::filesystem::path& path, const LabelledMesh& mesh, const Progress& progress = {});

}  // namespace gvd
