#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "gvd/generator_list.hpp"
#include "io/generators/list_location.hpp"

// Lines and fields of lists that are written line by line: text and comma-separated values.
namespace gvd::detail {

/// A line without its comment, line break and outer blanks.
struct ListLine {
  std::string_view text;
  std::int32_t number = 0;  ///< 1-based
};

/// The lines that are not empty. A byte order mark is skipped; # starts a comment. Cost: O(length).
std::vector<ListLine> split_lines(std::string_view content);

/// The fields of a line between blanks, and between any number of `separator`.
std::vector<std::string_view> split_fields(std::string_view text, char separator = ' ');

/// The number that `text` spells in full, in any locale.
template <class T>
std::optional<T> parse_field(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// An index >= 0. `what` names the element: "vertex". Throws Error{unreadable_input}.
std::int64_t parse_index(std::string_view field, std::string_view what, const ListLocation& location);

/// Three finite numbers. Throws Error{unreadable_input}.
std::array<double, 3> parse_values(const std::array<std::string_view, 3>& fields, const ListLocation& location);

/// The fields of a line.
struct ListRow {
  std::vector<std::string_view> fields;
  std::int32_t number = 0;  ///< 1-based line
};

/// The entries of a list whose rows are `V`, `F b0 b1 b2`, `p x y z` or `x y z`.
/// Three numbers are a position. The whole list decides: if every row of three holds different indices, they could be
/// vertices as well, and the list is refused rather than guessed at.
/// `name` is the list's, and `separator` stands between its fields: for messages.
/// Throws Error{unreadable_input} with name and line. Cost: O(fields).
std::vector<GeneratorEntry> parse_entries(const std::vector<ListRow>& rows, const std::string& name, char separator);

}  // namespace gvd::detail
