#include "io/generators/list_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gvd::detail {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

std::vector<std::string_view> split_blanks(std::string_view text) {
  std::vector<std::string_view> fields;
  for (std::size_t start = text.find_first_not_of(kBlanks); start != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, start), text.size());
    fields.push_back(text.substr(start, end - start));
    start = text.find_first_not_of(kBlanks, end);
  }
  return fields;
}

std::int64_t parse_index(std::string_view field, std::string_view what, const ListLocation& location) {
  const auto index = parse_field<std::int64_t>(field);
  if (!index || *index < 0) {
    location.refuse(fmt::format("{} is no index of a {}; indices are whole numbers from 0", quoted(field), what));
  }
  return *index;
}

std::array<double, 3> parse_values(const std::array<std::string_view, 3>& fields, const ListLocation& location) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_field<double>(fields[i]);
    if (!value || !std::isfinite(*value)) location.refuse(fmt::format("{} is no finite number", quoted(fields[i])));
    values[i] = *value;
  }
  return values;
}

GeneratorEntry parse_entry(const std::vector<std::string_view>& fields, const ListLocation& location) {
  GeneratorEntry entry;
  entry.line = location.line;
  if (fields.size() == 1) {
    entry.index = parse_index(fields[0], "vertex", location);
  } else if (fields.size() == 4) {
    entry.kind = fields[0] == "p" ? GeneratorEntry::Kind::position : GeneratorEntry::Kind::face;
    if (entry.kind == GeneratorEntry::Kind::face) entry.index = parse_index(fields[0], "face", location);
    entry.values = parse_values({fields[1], fields[2], fields[3]}, location);
  } else {
    location.refuse(fmt::format(
        "{} fields; write a vertex 'V', a face with coordinates 'F b0 b1 b2' or a position 'p x y z'", fields.size()));
  }
  return entry;
}

std::vector<ListLine> split_lines(std::string_view content) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (content.substr(0, kByteOrderMark.size()) == kByteOrderMark) content.remove_prefix(kByteOrderMark.size());
  std::vector<ListLine> lines;
  std::int32_t number = 0;
  for (std::size_t start = 0; start < content.size();) {
    const std::size_t end = std::min(content.find('\n', start), content.size());
    const std::string_view line = content.substr(start, end - start);
    ++number;
    const std::string_view text = trim(line.substr(0, line.find('#')));
    if (!text.empty()) lines.push_back({text, number});
    start = end + 1;
  }
  return lines;
}

}  // namespace gvd::detail
