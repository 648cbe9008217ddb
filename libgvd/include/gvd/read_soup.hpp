#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "gvd/io/format.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/polygon_soup.hpp"

namespace gvd {

/// The placeholder of the option that names the format of a mesh, with all names, for messages: "name the format with
/// ...".
std::string input_format_option();

/// The format of a file name's extension, or of a bare name such as "ply", in upper or lower case; nothing for any
/// other name. A final extension .gz is ignored.
std::optional<MeshFormat> format_from_extension(std::string_view name);

/// Detects the format of a file. The content decides first. GLB, VTP, VTU, VTK, GIFTI and FreeSurfer's surfaces begin
/// with a mark, PLY, OFF and MNI's objects with a first line, glTF is JSON with a member `asset`. STL is recognized by
/// its length or first word, OBJ by its first statement. Otherwise the extension of `name` decides. The result is
/// nothing if neither is known. The content of a gzip file is not examined. Cost: O(1) and the length of leading
/// comments; O(bytes) for glTF and UTF-16.
std::optional<MeshFormat> detect_format(std::string_view bytes, std::string_view name);

/// Reads a file as OBJ, PLY (ascii and binary), OFF (also COFF, NOFF, STOFF), STL (ascii and binary), VTP, VTU, VTK,
/// glTF (.glb and .gltf), GIFTI, MNI's polygons or FreeSurfer's triangles. VTK is the legacy format with PolyData; from
/// its unstructured grids, and from those of VTU, the cells that belong to a surface are read. Every file may be
/// compressed by gzip, and text may be UTF-16 with a byte order mark. The buffers of a glTF may be files in its folder
/// or below, but nowhere else.
///
/// `format` overrides the detection. Numbers are read in the same way in any locale. Vertices and polygons keep their
/// order.
/// Properties: (1) every index is in range; (2) every coordinate is finite; (3) there is at least one polygon;
/// (4) memory is bounded by a multiple of the size of the file and its buffers, whatever counts its header claims; a
/// gzip file may expand to at most 200 times its size plus 1 MB.
/// Throws Error{unreadable_input}, with the file and the line (in text) or byte (in binary files), if the file can't be
/// read or is damaged; Error{precondition} for a coordinate that is not finite or for more than 2,147,483,647 vertices.
/// Cost: O(bytes).
PolygonSoup read_soup(const std::filesystem::path& path, std::optional<MeshFormat> format = {});

/// Reads the property with this name from a PLY file's vertices or faces, or from a VTP's or VTU's points or cells. If
/// both have it, `preferred` decides. Names of arrays may differ in upper and lower case. Returns nothing if the file
/// has no such property or another format. Throws Error{unreadable_input} if the file can't be read.
/// Cost: O(bytes).
std::optional<SoupProperty> read_soup_property(const std::filesystem::path& path, std::string_view property,
                                               SoupElement preferred = SoupElement::vertex);

/// Like `read_soup`, for bytes in memory. `name` stands for the file in messages, and its extension may determine the
/// format. A glTF must contain its buffers.
PolygonSoup parse_soup(std::string_view bytes, std::optional<MeshFormat> format, std::string_view name);

/// Reads further properties of vertices and polygons. From PLY, these are all properties except coordinates, texture
/// coordinates, which `read_soup` reads, and properties of triangle strips, in the file's order. From OBJ, these are
/// the colours of vertices as `red`, `green`, `blue` and, if a vertex has one, `alpha`, of 8 bits. Other formats give
/// nothing, even if they have data of points and cells. `format` overrides the detection.
/// Throws Error{unreadable_input} if the file can't be read. Cost: O(bytes).
std::vector<MeshProperty> read_mesh_properties(const std::filesystem::path& path,
                                               std::optional<MeshFormat> format = {});

/// Like `read_mesh_properties`, for bytes in memory. `name` stands for the file in messages.
std::vector<MeshProperty> parse_mesh_properties(std::string_view bytes, MeshFormat format, std::string_view name);

}  // namespace gvd
