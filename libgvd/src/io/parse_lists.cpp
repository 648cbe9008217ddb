// Lists that are written line by line: their lines, fields and entries, as text and as comma-separated values.
//
// An entry says by the number of its fields what it is: one is a vertex, four a face with coordinates or a position
// behind `p`, three a position. Whether three whole numbers are a position or three vertices only the whole list tells.
// Comma-separated values without a header have the same fields. Below a header each row fills the columns of one kind:
// a face with coordinates before a vertex, and a vertex before a position. So a list that this library wrote, which has
// both face and position, comes back bit by bit.
// Invariant: a list that could be read in two ways is refused, never guessed at. Every message names list and line.
#include "io/parse_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::detail {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::string_view kBlanks = " \t\r\f\v";

std::string_view trim(std::string_view text, std::string_view blanks = kBlanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// An index >= 0. `what` names the element: "vertex".
std::int64_t parse_index(std::string_view field, std::string_view what, const ListLocation& location) {
  const auto index = parse_number<std::int64_t>(field);
  if (!index || *index < 0) {
    location.refuse(fmt::format("{} is no index of a {}; indices are whole numbers from 0", quoted(field), what));
  }
  return *index;
}

/// Three finite numbers.
std::array<double, 3> parse_values(const std::array<std::string_view, 3>& fields, const ListLocation& location) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_number<double>(fields[i]);
    if (!value || !std::isfinite(*value)) location.refuse(fmt::format("{} is no finite number", quoted(fields[i])));
    values[i] = *value;
  }
  return values;
}

/// Whether the three fields are different indices. Coordinates are seldom all whole, not negative and different.
bool could_be_vertices(const Fields& fields) {
  std::array<std::int64_t, 3> indices{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto index = parse_number<std::int64_t>(fields[i]);
    if (!index || *index < 0) return false;
    indices[i] = *index;
  }
  return indices[0] != indices[1] && indices[1] != indices[2] && indices[2] != indices[0];
}

/// "p x y z" with the separator of the list.
std::string spell(std::string fields, char separator) {
  std::replace(fields.begin(), fields.end(), ' ', separator);
  return fields;
}

/// The first of four fields, which is not `p`.
std::int64_t parse_face(std::string_view field, const ListLocation& location, char separator) {
  if (!parse_number<double>(field)) {
    location.refuse(fmt::format("{} is no index of a face; write '{}' or, for a position, '{}'", quoted(field),
                                spell("F b0 b1 b2", separator), spell("p x y z", separator)));
  }
  return parse_index(field, "face", location);
}

GeneratorEntry parse_entry(const Fields& fields, const ListLocation& location, char separator) {
  GeneratorEntry entry;
  entry.line = location.line;
  if (fields.size() == 1) {
    entry.index = parse_index(fields[0], "vertex", location);
  } else if (fields.size() == 4) {
    entry.kind = fields[0] == "p" ? GeneratorEntry::Kind::position : GeneratorEntry::Kind::face;
    if (entry.kind == GeneratorEntry::Kind::face) entry.index = parse_face(fields[0], location, separator);
    entry.values = parse_values({fields[1], fields[2], fields[3]}, location);
  } else if (fields.size() == 3) {
    entry.kind = GeneratorEntry::Kind::position;
    entry.values = parse_values({fields[0], fields[1], fields[2]}, location);
  } else {
    location.refuse(fmt::format("{}; write a vertex 'V', a face with coordinates '{}' or a position '{}' or '{}'",
                                counted(std::ssize(fields), "field", "fields"), spell("F b0 b1 b2", separator),
                                spell("x y z", separator), spell("p x y z", separator)));
  }
  return entry;
}

Fields split_commas(std::string_view text) {
  Fields fields;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    fields.push_back(trim(text.substr(start, end - start), " \t\""));
    start = end + 1;
  }
  return fields;
}

/// The first field of a header is a name: neither a number nor the `p` of a position.
bool is_header(const Fields& fields) {
  return fields[0] != "p" && !fields[0].empty() && !parse_number<double>(fields[0]);
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

std::string ListLocation::text() const { return line > 0 ? fmt::format("{}:{}", name, line) : name; }

void ListLocation::refuse(const std::string& message) const {
  throw Error(ErrorCode::unreadable_input, text() + ": " + message, line > 0 ? line - 1 : -1);
}

std::vector<std::string_view> split_fields(std::string_view text, char separator) {
  const auto is_between = [separator](char c) { return c == separator || kBlanks.find(c) != kBlanks.npos; };
  Fields fields;
  for (auto start = text.begin(); start != text.end();) {
    start = std::find_if_not(start, text.end(), is_between);
    const auto end = std::find_if(start, text.end(), is_between);
    if (start != end) fields.emplace_back(start, end);
    start = end;
  }
  return fields;
}

std::vector<GeneratorEntry> parse_entries(const std::vector<ListRow>& rows, const std::string& name, char separator) {
  std::vector<GeneratorEntry> entries;
  const ListRow* doubtful = nullptr;
  bool plain = false;
  for (const ListRow& row : rows) {
    entries.push_back(parse_entry(row.fields, {name, row.number}, separator));
    if (row.fields.size() != 3) continue;
    if (!could_be_vertices(row.fields)) plain = true;
    if (doubtful == nullptr) doubtful = &row;
  }
  if (doubtful != nullptr && !plain) {
    const std::string text = fmt::format("{}", fmt::join(doubtful->fields, std::string_view(&separator, 1)));
    ListLocation{name, doubtful->number}.refuse(
        fmt::format("'{0}' could be a position or three vertices; write 'p{1}{0}' for a position, or one vertex a line",
                    text, separator));
  }
  return entries;
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

std::vector<GeneratorEntry> parse_text(std::string_view content, const std::string& name) {
  std::vector<ListRow> rows;
  for (const auto& [text, number] : split_lines(content)) {
    if (text.find(',') != text.npos) {
      ListLocation{name, number}.refuse("has a comma; part the fields by blanks, or give the list as CSV");
    }
    rows.push_back({split_fields(text), number});
  }
  return parse_entries(rows, name, ' ');
}

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
