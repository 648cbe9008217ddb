#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_list.hpp"

// Parses lists from text, comma-separated values and PLY. `name` is how messages call the list.
namespace gvd::detail {

/// A line of a list, for messages. The string `name` must outlive it.
struct ListLocation {
  const std::string& name;  ///< of the file or option
  std::int32_t line = 0;    ///< 1-based; 0 if the list has no lines

  /// Throws Error{unreadable_input} with the location before the message.
  [[noreturn]] void refuse(const std::string& message) const;
  /// "name:line", or the name alone without a line.
  std::string text() const;
};

/// A line without its comment, its line break, and the blanks around it.
struct ListLine {
  std::string_view text;
  std::int32_t number = 0;  ///< 1-based
};

/// Splits content into lines, and returns the first `most` of them that are not empty. Skips a byte order mark; #
/// starts a comment.
/// Cost: O(length of what is read).
std::vector<ListLine> split_lines(std::string_view content, std::size_t most = std::numeric_limits<std::size_t>::max());

/// Splits a line into fields at blanks and at `separator`, also at several in a row.
std::vector<std::string_view> split_fields(std::string_view text, char separator = ' ');

/// The fields of a line.
struct ListRow {
  std::vector<std::string_view> fields;
  std::int32_t number = 0;  ///< 1-based line
};

/// Parses the entries of a list whose rows are `V`, `F b0 b1 b2`, `p x y z`, `x y z` or `x y z nx ny nz`.
/// Three numbers are a position. But if every row of three in the list holds different indices, the rows could be
/// vertices as well, and the list is refused. `separator` stands between the fields of the list, for messages.
/// Throws Error{unreadable_input} with name and line. Cost: O(fields).
std::vector<GeneratorEntry> parse_entries(const std::vector<ListRow>& rows, const std::string& name, char separator);

/// Parses a list as text, one entry a line: `V`, `F b0 b1 b2`, `p x y z`, `x y z`, or `x y z nx ny nz`, a position with
/// a normal; # starts a comment. Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_text(std::string_view content, const std::string& name);

/// Parses positions from text (.xyz): a line begins with `x y z`, and its further fields are ignored. Throws as
/// `parse_text` does.
std::vector<GeneratorEntry> parse_xyz(std::string_view content, const std::string& name);

/// Reads the vertices of a PLY: as surface points if they have the properties `face`, `b0`, `b1` and `b2`, as in the
/// samples that gvd-lloyd writes; otherwise as positions. Throws Error{unreadable_input} with name. Cost: O(length).
std::vector<GeneratorEntry> parse_ply_points(std::string_view content, const std::string& name);

/// Parses comma-separated values, with the fields of the text form or with columns named by a header.
/// Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_csv(std::string_view content, const std::string& name);

/// A number for each element of a mesh, read from a table.
struct ElementTable {
  bool of_vertices = true;      ///< otherwise of faces
  std::size_t columns = 1;      ///< how many columns of numbers the table has
  std::vector<double> numbers;  ///< of the last column, in the order of the elements
};

/// Whether the first line that is no comment is the header of a table with a column `face` or `vertex`.
/// Cost: O(length up to this line).
bool is_element_table(std::string_view content);

/// Refuses a text whose first line names columns but is no such header: it has no column of vertices or faces, or its
/// separators are not commas. Throws Error{unreadable_input} with name and line. Cost: O(length of two lines).
void refuse_other_table(std::string_view content, const std::string& name);

/// Parses a table with such a header, as this library writes it: `face,label`, `vertex,label`, `face,label_1,label_2`
/// or `source,vertex,distance`. Each element from 0 on has one row; rows may come in any order.
/// Throws Error{unreadable_input} with name and line. Cost: O(length).
ElementTable parse_element_table(std::string_view content, const std::string& name);

}  // namespace gvd::detail
