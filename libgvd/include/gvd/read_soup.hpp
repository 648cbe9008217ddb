#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "gvd/io/format.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/polygon_soup.hpp"

namespace gvd {

/// A placeholder for the option that names the format of a mesh, with all names, for texts: "name the format with ...".
std::string input_format_option();

/// The format that a file name's extension, or a bare name such as "ply", stands for, in upper or lower case; nothing
/// for any other name. An extension .gz behind it is ignored.
std::optional<MeshFormat> format_from_extension(std::string_view name);

/// The format of a file. The content decides first. GLB, VTP, VTU, VTK, GIFTI and FreeSurfer's surfaces begin with a
/// mark, PLY, OFF and MNI's objects with a first line, glTF is JSON with a member `asset`. STL is known by its length
/// or first word, OBJ by its first statement. Otherwise the extension of `name` decides. Nothing where neither is
/// known. The content of a gzip file says nothing. Cost: O(1), O(length) of leading comments, and of glTF and UTF-16
/// O(bytes).
std::optional<MeshFormat> detect_format(std::string_view bytes, std::string_view name);

/// Reads a file as OBJ, PLY (ascii and binary), OFF (also COFF, NOFF, STOFF), STL (ascii and binary), VTP, VTU, VTK,
/// glTF (.glb and .gltf), GIFTI, MNI's polygons or FreeSurfer's triangles. VTK is the legacy format, with PolyData; of
/// its unstructured grids and those of VTU, cells of a surface are read. Each may be packed by gzip, and text may be
/// UTF-16 with a byte order mark. Buffers of glTF may be files beside it, in its folder or below, nowhere else.
///
/// `format` overrides the detection. Numbers do not depend on the locale. Vertices and polygons keep their order.
/// Properties: (1) every index is in range; (2) every coordinate is finite; (3) there is at least one polygon;
/// (4) memory is bounded by a multiple of the file's size, with that of its buffers, whatever counts its header gives:
/// gzip may unfold to 200 times the size of the file, and 1 MB.
/// Throws Error{unreadable_input} with the file and the line (in text) or byte (in binary files), and
/// Error{precondition} for a coordinate that is not finite or for more vertices than 2,147,483,647.
/// Cost: O(bytes).
PolygonSoup read_soup(const std::filesystem::path& path, std::optional<MeshFormat> format = {});

/// The property of this name of a PLY file's vertices or faces, or an array of a VTP's or VTU's points or cells; of
/// those that are preferred where both have one. Names of arrays may differ in upper and lower case. None where the
/// file has no such property, or is another one. Throws Error{unreadable_input} where it can't be read.
/// Cost: O(bytes).
std::optional<SoupProperty> read_soup_property(const std::filesystem::path& path, std::string_view property,
                                               SoupElement preferred = SoupElement::vertex);

/// `read_soup` from bytes in memory; `name` stands for the file in messages, and its extension may tell the format. A
/// glTF must have its buffers inside.
PolygonSoup parse_soup(std::string_view bytes, std::optional<MeshFormat> format, std::string_view name);

/// PLY: the properties of vertices but for their coordinates, and of polygons, in the file's order. Those of a texture,
/// which `read_soup` reads, and of strips of triangles are left out. OBJ: the colours of vertices as `red`, `green`,
/// `blue` and, where a vertex has one, `alpha`, of 8 bits. Nothing of other formats, also where they have data of
/// points and cells. `format` overrides the detection.
/// Throws Error{unreadable_input} where the file can't be read. Cost: O(bytes).
std::vector<MeshProperty> read_mesh_properties(const std::filesystem::path& path,
                                               std::optional<MeshFormat> format = {});

/// `read_mesh_properties` from bytes in memory; `name` stands for the file in messages.
std::vector<MeshProperty> parse_mesh_properties(std::string_view bytes, MeshFormat format, std::string_view name);

}  // namespace gvd
