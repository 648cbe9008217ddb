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

/// The fields of a line, separated by blanks.
std::vector<std::string_view> split_blanks(std::string_view text);

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

/// An entry out of the fields `V`, `F b0 b1 b2` or `p x y z`. Throws Error{unreadable_input}.
GeneratorEntry parse_entry(const std::vector<std::string_view>& fields, const ListLocation& location);

}  // namespace gvd::detail
