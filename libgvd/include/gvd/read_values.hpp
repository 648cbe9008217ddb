#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// The numbers of a file that has one for each vertex, or for each face, of a mesh: in the file's order.
///
/// The content decides on the format, and each may be packed by gzip:
/// - GIFTI with one array of labels, shapes or functions (.label.gii, .shape.gii, .func.gii);
/// - FreeSurfer's annotations (.annot) and values (lh.curv, lh.thickness);
/// - NumPy's arrays (.npy) of one dimension;
/// - a table of comma-separated values with a header, one column `face` or `vertex` and one of numbers, such as
///   `face,label` (`source` does not count): in any order of its rows;
/// - otherwise a text of numbers between blanks, commas and line ends, in which # begins a comment.
///
/// The label of a vertex is its key in GIFTI's table, or its number in FreeSurfer's; it is -1
/// where FreeSurfer's table lacks its colour.
/// Throws Error{unreadable_input} that names the file, where it can't be read or holds anything else.
/// Cost: O(bytes).
std::vector<double> read_values(const std::filesystem::path& path);

/// `read_values` from bytes in memory; `name` stands for the file in messages.
std::vector<double> parse_values(std::string_view bytes, std::string_view name);

/// A number for each vertex, or for each polygon, of the file that a mesh was made from.
struct ElementValues {
  std::string title;  ///< where they come from, for messages
  SoupProperty soup;  ///< of vertices: as many as `mesh_vertex`; of polygons: one for each of `input_polygon`, or more
  bool of_mesh = false;  ///< the numbers are those of the mesh's vertices or faces, after triangulation and repair
};

/// What becomes of a file with several numbers for each element, such as labels at several levels.
enum class ValueColumns {
  one,   ///< it is refused
  last,  ///< the last numbers count, which are those of the finest level
};

/// The numbers that `name` stands for: a file of values with one for each vertex, or for each polygon, of the input, or
/// where these have other numbers, for each vertex or face of the mesh, as the commands write labels and distances;
/// else the property of that name of `mesh_file`, a PLY, VTP or VTU from which `input` was made (empty: none), of the
/// preferred elements where both have it. Nothing where there is neither.
/// Throws Error{unreadable_input} where a file can't be read or has too few or too many numbers. Cost: O(bytes).
std::optional<ElementValues> read_element_values(const CheckedMesh& input, const std::string& name,
                                                 const std::filesystem::path& mesh_file,
                                                 SoupElement preferred = SoupElement::vertex,
                                                 ValueColumns columns = ValueColumns::one);

}  // namespace gvd
