#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/names.hpp"
#include "gvd/vec.hpp"

namespace gvd {

enum class MeshFormat { obj, ply, off, stl, vtp, vtu, vtk, glb, gltf, gii, mni, fs };
inline const Choices<MeshFormat> kMeshFormatNames{
    {"obj", MeshFormat::obj},   {"ply", MeshFormat::ply}, {"off", MeshFormat::off}, {"stl", MeshFormat::stl},
    {"vtp", MeshFormat::vtp},   {"vtu", MeshFormat::vtu}, {"vtk", MeshFormat::vtk}, {"glb", MeshFormat::glb},
    {"gltf", MeshFormat::gltf}, {"gii", MeshFormat::gii}, {"mni", MeshFormat::mni}, {"fs", MeshFormat::fs}};

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

/// Polygons as a file gives them. How they are connected is not known.
struct PolygonSoup {
  std::vector<Vec3> positions;               ///< mesh units
  std::vector<std::int32_t> corners;         ///< of all polygons, one after the other: indices into `positions`
  std::vector<std::size_t> first_corner{0};  ///< per polygon, and the number of corners at the end
  bool unwelded = false;                     ///< whether polygons may have vertices of their own (STL, GLB)
  std::optional<double> weld_tolerance;      ///< of `weld_soup`, in mesh units; nothing where nobody asked for it
  Appearance appearance;                     ///< of the polygons: texture coordinates and materials
  std::vector<std::string> notes;            ///< what the reader left out, one line each

  /// Makes a polygon of the corners that were appended last.
  void close_polygon() { first_corner.push_back(corners.size()); }
  std::size_t polygon_count() const { return first_corner.size() - 1; }
  std::span<const std::int32_t> polygon(std::size_t p) const {
    return {corners.data() + first_corner[p], first_corner[p + 1] - first_corner[p]};
  }
};

/// The soup of two arrays: three coordinates for each vertex, in mesh units, and `size` corners for each polygon.
/// Throws Error{precondition} for a corner that is no vertex. Cost: O(n).
PolygonSoup make_soup(std::span<const double> coordinates, std::span<const std::int64_t> corners, std::size_t size = 3);

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

/// A number for each vertex, or for each polygon, of a file.
struct SoupProperty {
  bool of_vertices = true;  ///< otherwise of polygons
  std::vector<double> values;
};

enum class SoupElement { vertex, polygon };

/// The property of this name of a PLY file's vertices or faces, or an array of a VTP's or VTU's points or cells; of
/// those that are preferred where both have one. Names of arrays may differ in upper and lower case. None where the
/// file has no such property, or is another one. Throws Error{unreadable_input} where it can't be read.
/// Cost: O(bytes).
std::optional<SoupProperty> read_soup_property(const std::filesystem::path& path, std::string_view property,
                                               SoupElement preferred = SoupElement::vertex);

/// `read_soup` from bytes in memory; `name` stands for the file in messages. A glTF must have its buffers inside.
PolygonSoup parse_soup(std::string_view bytes, MeshFormat format, std::string_view name);

}  // namespace gvd
