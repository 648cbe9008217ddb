// Lists as comma-separated values: the fields of the text form, or named columns below a header.
#include <fmt/format.h>

#include <algorithm>

#include "io/generators/generator_list_detail.hpp"

namespace gvd::detail {
namespace {

using Fields = std::vector<std::string_view>;

Fields split_commas(std::string_view text) {
  constexpr std::string_view kBlanksAndQuotes = " \t\"";
  Fields fields;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    std::string_view field = text.substr(start, end - start);
    field.remove_prefix(std::min(field.find_first_not_of(kBlanksAndQuotes), field.size()));
    fields.push_back(field.substr(0, field.find_last_not_of(kBlanksAndQuotes) + 1));
    start = end + 1;
  }
  return fields;
}

/// A header holds names: its first field is neither a number nor the `p` before a position.
bool is_header(const Fields& fields) {
  return fields[0] != "p" && !fields[0].empty() && !parse_field<double>(fields[0]);
}

/// Which column holds what; -1 where it is absent.
struct Columns {
  std::ptrdiff_t vertex = -1, face = -1;
  std::array<std::ptrdiff_t, 3> bary{-1, -1, -1}, position{-1, -1, -1};
  std::size_t count = 0;
};

Columns read_header(const Fields& names, const ListPlace& place) {
  const auto find = [&](std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : found - names.begin();
  };
  Columns columns{find("vertex"),
                  find("face"),
                  {find("b0"), find("b1"), find("b2")},
                  {find("x"), find("y"), find("z")},
                  names.size()};
  const auto whole = [](const std::array<std::ptrdiff_t, 3>& three) {
    return *std::min_element(three.begin(), three.end()) >= 0;
  };
  if (!whole(columns.bary)) columns.face = -1;
  if (!whole(columns.position)) columns.position = {-1, -1, -1};
  if (columns.vertex < 0 && columns.face < 0 && columns.position[0] < 0) {
    place.refuse("the header names no generators; it needs the columns vertex, or face,b0,b1,b2, or x,y,z");
  }
  return columns;
}

/// A row takes the first of face, vertex and position that it fills.
GeneratorEntry read_row(const Columns& columns, const Fields& fields, const ListPlace& place) {
  if (fields.size() != columns.count) {
    place.refuse(fmt::format("{} fields where the header has {}", fields.size(), columns.count));
  }
  const auto field = [&](std::ptrdiff_t column) {
    return column < 0 ? std::string_view() : fields[static_cast<std::size_t>(column)];
  };
  const auto three = [&](const std::array<std::ptrdiff_t, 3>& c) {
    return std::array<std::string_view, 3>{field(c[0]), field(c[1]), field(c[2])};
  };
  if (!field(columns.face).empty()) {
    const std::int64_t face = parse_index(field(columns.face), "face", place);
    return {GeneratorEntry::Kind::face, face, parse_values(three(columns.bary), place), place.line};
  }
  if (!field(columns.vertex).empty()) {
    return {GeneratorEntry::Kind::vertex, parse_index(field(columns.vertex), "vertex", place), {}, place.line};
  }
  return {GeneratorEntry::Kind::position, 0, parse_values(three(columns.position), place), place.line};
}

}  // namespace

std::vector<GeneratorEntry> parse_csv(std::string_view content, const std::string& name) {
  std::vector<GeneratorEntry> entries;
  std::optional<Columns> columns;
  bool first = true;
  for (const auto& [text, number] : split_lines(content)) {
    const ListPlace place{name, number};
    const Fields fields = split_commas(text);
    if (first && is_header(fields)) {
      columns = read_header(fields, place);
    } else {
      entries.push_back(columns ? read_row(*columns, fields, place) : parse_entry(fields, place));
    }
    first = false;
  }
  return entries;
}

}  // namespace gvd::detail
