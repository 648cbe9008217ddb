// Lists as comma-separated values.
//
// Without a header the fields of a line are those of the text form. Below a header each row fills the columns of one
// kind: a face with coordinates before a vertex, and a vertex before a position. So a list that this library wrote,
// which has both face and position, comes back bit by bit.
#include <fmt/format.h>

#include <algorithm>

#include "gvd/text.hpp"
#include "io/parse_lists.hpp"

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

/// The first field of a header is a name: neither a number nor the `p` of a position.
bool is_header(const Fields& fields) {
  return fields[0] != "p" && !fields[0].empty() && !parse_field<double>(fields[0]);
}

/// The columns of each field; -1 where the header has none.
struct Columns {
  std::ptrdiff_t vertex = -1, face = -1;
  std::array<std::ptrdiff_t, 3> bary{-1, -1, -1}, position{-1, -1, -1};
  std::size_t count = 0;
};

Columns read_header(const Fields& names, const ListLocation& location) {
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
    location.refuse(
        "the header names no generators; it needs the columns vertex, or face,b0,b1,b2, or x,y,z, with commas between");
  }
  return columns;
}

/// The entry of a row: the first of face, vertex and position that the row fills.
GeneratorEntry read_row(const Columns& columns, const Fields& fields, const ListLocation& location) {
  if (fields.size() != columns.count) {
    location.refuse(fmt::format("{}, but the header has {}; give as many as the header",
                                counted(std::ssize(fields), "field", "fields"), columns.count));
  }
  const auto field = [&](std::ptrdiff_t column) { return column < 0 ? std::string_view() : fields[column]; };
  const auto three = [&](const std::array<std::ptrdiff_t, 3>& c) {
    return std::array<std::string_view, 3>{field(c[0]), field(c[1]), field(c[2])};
  };
  if (!field(columns.face).empty()) {
    const std::int64_t face = parse_index(field(columns.face), "face", location);
    return {GeneratorEntry::Kind::face, face, parse_values(three(columns.bary), location), location.line};
  }
  if (!field(columns.vertex).empty()) {
    return {GeneratorEntry::Kind::vertex, parse_index(field(columns.vertex), "vertex", location), {}, location.line};
  }
  return {GeneratorEntry::Kind::position, 0, parse_values(three(columns.position), location), location.line};
}

}  // namespace

std::vector<GeneratorEntry> parse_csv(std::string_view content, const std::string& name) {
  std::vector<ListRow> rows;
  for (const auto& [text, number] : split_lines(content)) rows.push_back({split_commas(text), number});
  if (rows.empty() || !is_header(rows.front().fields)) return parse_entries(rows, name, ',');
  const Columns columns = read_header(rows.front().fields, {name, rows.front().number});
  std::vector<GeneratorEntry> entries;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    entries.push_back(read_row(columns, rows[i].fields, {name, rows[i].number}));
  }
  return entries;
}

}  // namespace gvd::detail
