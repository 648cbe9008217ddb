#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_list.hpp"

namespace gvd::detail {

/// The number that `text` spells in full, in any locale.
template <class T>
std::optional<T> parse_field(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Reports errors of one list with its name and line.
struct ListPlace {
  const std::string& name;
  std::int32_t line = 0;

  /// Throws Error{unreadable_input}.
  [[noreturn]] void refuse(const std::string& message) const;
  /// "name:line", or the name where there is no line.
  std::string text() const;
};

/// The text between quotes, shortened and without control characters, for a message.
std::string quoted(std::string_view text);

/// An index >= 0. Throws Error{unreadable_input}.
std::int64_t parse_index(std::string_view field, std::string_view what, const ListPlace& place);

/// Three finite numbers. Throws Error{unreadable_input}.
std::array<double, 3> parse_values(const std::array<std::string_view, 3>& fields, const ListPlace& place);

/// An entry out of the fields `V`, `F b0 b1 b2` or `p x y z`. Throws Error{unreadable_input}.
GeneratorEntry parse_entry(const std::vector<std::string_view>& fields, const ListPlace& place);

/// A line without its comment, line break and outer blanks.
struct ListLine {
  std::string_view text;
  std::int32_t number = 0;  ///< 1-based
};

/// The lines that are not empty.
std::vector<ListLine> split_lines(std::string_view content);

std::vector<GeneratorEntry> parse_text(std::string_view content, const std::string& name);
std::vector<GeneratorEntry> parse_csv(std::string_view content, const std::string& name);
std::vector<GeneratorEntry> parse_json(std::string_view content, const std::string& name);

}  // namespace gvd::detail
