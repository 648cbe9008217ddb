#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_list.hpp"

// Lists as text, comma-separated values and PLY. `name` is the list's in all messages.
namespace gvd::detail {

/// A line of a list, for messages. `name` must outlive it.
struct ListLocation {
  const std::string& name;  ///< of the file or option
  std::int32_t line = 0;    ///< 1-based; 0 where the list has no lines

  /// Throws Error{unreadable_input} with the location before the message.
  [[noreturn]] void refuse(const std::string& message) const;
  /// "name:line", or the name where there is no line.
  std::string text() const;
};

/// A line without its comment, line break and outer blanks.
struct ListLine {
  std::string_view text;
  std::int32_t number = 0;  ///< 1-based
};

/// The lines that are not empty, the first `most` of them. A byte order mark is skipped; # starts a comment. Cost:
/// O(length) of what is read.
std::vector<ListLine> split_lines(std::string_view content, std::size_t most = std::numeric_limits<std::size_t>::max());

/// The fields of a line between blanks, and between any number of `separator`.
std::vector<std::string_view> split_fields(std::string_view text, char separator = ' ');

/// A line as its fields.
struct ListRow {
  std::vector<std::string_view> fields;
  std::int32_t number = 0;  ///< 1-based line
};

/// The entries of a list whose rows are `V`, `F b0 b1 b2`, `p x y z`, `x y z` or `x y z nx ny nz`.
/// Three numbers are a position. The whole list decides: if every row of three holds different indices, the rows could
/// be vertices as well, and the list is refused rather than guessed at. `separator` stands between the fields of the
/// list, for messages.
/// Throws Error{unreadable_input} with name and line. Cost: O(fields).
std::vector<GeneratorEntry> parse_entries(const std::vector<ListRow>& rows, const std::string& name, char separator);

/// Parses a list as text, one entry a line: `V`, `F b0 b1 b2`, `p x y z`, `x y z`, or `x y z nx ny nz`, a position with
/// a normal; # starts a comment. Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_text(std::string_view content, const std::string& name);

/// Parses positions as text, `x y z` and whatever follows in a line (.xyz). Throws as `parse_text` does.
std::vector<GeneratorEntry> parse_xyz(std::string_view content, const std::string& name);

/// The vertices of a PLY: points with the properties `face`, `b0`, `b1` and `b2`, as gvd-lloyd writes its samples; else
/// positions. Throws Error{unreadable_input} with name. Cost: O(length).
std::vector<GeneratorEntry> parse_ply_points(std::string_view content, const std::string& name);

/// Parses comma-separated values: the fields of the text form, or named columns below a header.
/// Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_csv(std::string_view content, const std::string& name);

/// Numbers of the elements of a mesh, from a table.
struct ElementTable {
  bool of_vertices = true;      ///< otherwise of faces
  std::size_t columns = 1;      ///< of numbers
  std::vector<double> numbers;  ///< of the last one of these, in the order of the elements
};

/// Whether the first line, comments aside, is the header of a table with a column `face` or `vertex`. Cost: O(length
/// up to this line).
bool is_element_table(std::string_view content);

/// Refuses a text whose first line names columns: a table without one of vertices or faces, or with other separators
/// than commas. Throws Error{unreadable_input} with name and line. Cost: O(length of two lines).
void refuse_other_table(std::string_view content, const std::string& name);

/// Parses comma-separated values below such a header, as this library writes them: `face,label`, `vertex,label`,
/// `face,label_1,label_2` or `source,vertex,distance`. Each element from 0 on has one row; rows may come in any order.
/// Throws Error{unreadable_input} with name and line. Cost: O(length).
ElementTable parse_element_table(std::string_view content, const std::string& name);

}  // namespace gvd::detail
