#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// Reads a file with one number for each vertex, or for each face, of a mesh. The numbers keep the order of the file.
///
/// The content determines the format, and every file may be compressed by gzip:
/// - GIFTI with one array of labels, shapes or functions (.label.gii, .shape.gii, .func.gii);
/// - FreeSurfer's annotations (.annot) and values (lh.curv, lh.thickness);
/// - one-dimensional arrays of NumPy (.npy);
/// - a table of comma-separated values with a header, one column `face` or `vertex` and one column of numbers, such as
///   `face,label` (a column `source` is ignored). The rows may have any order;
/// - otherwise, a text with numbers that are separated by blanks, commas and line ends; # begins a comment.
///
/// The label of a vertex is its key in GIFTI's table, or its number in FreeSurfer's; it is -1 if FreeSurfer's table
/// lacks its colour.
/// Throws Error{unreadable_input}, which names the file, if it can't be read or holds anything else.
/// Cost: O(bytes).
std::vector<double> read_values(const std::filesystem::path& path);

/// Like `read_values`, for bytes in memory. `name` stands for the file in messages.
std::vector<double> parse_values(std::string_view bytes, std::string_view name);

/// One number for each vertex, or for each polygon, of the file that a mesh was made from.
struct ElementValues {
  std::string title;  ///< where they come from, for messages
  SoupProperty soup;  ///< for vertices, as many as CheckedMesh::mesh_vertex; for polygons, at least one for each that
                      ///< `input_polygon` names
  bool of_mesh = false;  ///< if true, the elements are those of the mesh, after triangulation and repair
};

/// Decides how a file is read that has several numbers for each element, such as labels at several levels.
enum class ValueColumns {
  one,   ///< refuse it
  last,  ///< use the last numbers, which are those of the finest level
};

/// Finds the numbers that `name` stands for. If there is a file with this name, its numbers are read, and their count
/// tells what they belong to: the vertices of the input, its polygons, or the vertices or faces of the mesh, as the
/// commands write labels and distances; the first of these that fits is taken. Otherwise `name` is a property of
/// `mesh_file`, the PLY, VTP or VTU from which `input` was made (empty for none); if vertices and polygons have it,
/// `preferred` decides. Returns nothing if there is neither. Throws Error{unreadable_input} if a file can't be read or
/// has too few or too many numbers. Cost: O(bytes).
std::optional<ElementValues> read_element_values(const CheckedMesh& input, const std::string& name,
                                                 const std::filesystem::path& mesh_file,
                                                 SoupElement preferred = SoupElement::vertex,
                                                 ValueColumns columns = ValueColumns::one);

}  // namespace gvd
