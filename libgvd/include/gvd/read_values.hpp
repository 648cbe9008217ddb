#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace gvd {

/// The numbers of a file that has one for each vertex, or for each face, of a mesh: in the file's order.
///
/// The content decides on the format, and each may be packed by gzip:
/// - GIFTI with one array of labels, shapes or functions (.label.gii, .shape.gii, .func.gii);
/// - FreeSurfer's annotations (.annot) and values (lh.curv, lh.thickness);
/// - NumPy's arrays (.npy) of one dimension;
/// - otherwise a text of numbers between blanks, commas and line ends, in which # begins a comment.
///
/// The label of a vertex is its key in GIFTI's table, or its number in FreeSurfer's; it is -1
/// where FreeSurfer's table lacks its colour.
/// Throws Error{unreadable_input} that names the file, where it can't be read or holds anything else.
/// Cost: O(bytes).
std::vector<double> read_values(const std::filesystem::path& path);

/// `read_values` from bytes in memory; `name` stands for the file in messages.
std::vector<double> parse_values(std::string_view bytes, std::string_view name);

}  // namespace gvd
