// Parses lists line by line, as text and as comma-separated values; the vertices of a PLY; and tables of numbers.
//
// The number of fields tells what an entry is: one field is a vertex, four are a face with coordinates or a position
// after `p`, three are a position. Only the whole list tells whether three whole numbers are a position or three
// vertices. Comma-separated values without a header have the same fields. With a header, a row is read as a face with
// coordinates if it fills these columns, otherwise as a vertex, otherwise as a position; elements of JSON are read
// alike. So a list that this library wrote, with both face and position, comes back bit by bit.
//
// Invariant: a list that could be read in two ways is refused, never guessed at. Every message gives the name of the
// list and the line, and is printable whatever the file holds.
#include "io/parse_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd::detail {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::string_view kBlanks = " \t\r\f\v", kByteOrderMark = "\xef\xbb\xbf";

std::string_view trim(std::string_view text, std::string_view blanks = kBlanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Parses an index >= 0. `what` names the element in messages: "vertex".
std::int64_t parse_index(std::string_view field, std::string_view what, const ListLocation& location) {
  const auto index = parse_number<std::int64_t>(field);
  if (!index || *index < 0) {
    location.refuse(fmt::format("{} is not an index of a {}; indices are whole numbers from 0", quoted(field), what));
  }
  return *index;
}

/// Parses three finite numbers.
std::array<double, 3> parse_values(const std::array<std::string_view, 3>& fields, const ListLocation& location) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_number<double>(fields[i]);
    if (!value || !std::isfinite(*value)) location.refuse(fmt::format("{} is not a finite number", quoted(fields[i])));
    values[i] = *value;
  }
  return values;
}

/// Whether the three fields are different indices. Coordinates are seldom all whole, non-negative and different.
bool could_be_vertices(const Fields& fields) {
  std::array<std::int64_t, 3> indices{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto index = parse_number<std::int64_t>(fields[i]);
    if (!index || *index < 0) return false;
    indices[i] = *index;
  }
  return indices[0] != indices[1] && indices[1] != indices[2] && indices[2] != indices[0];
}

/// Spells a form such as "p x y z" with the separator of the list.
std::string spell(std::string fields, char separator) {
  std::replace(fields.begin(), fields.end(), ' ', separator);
  return fields;
}

/// Parses the first of four fields, which is not `p`, as a face.
std::int64_t parse_face(std::string_view field, const ListLocation& location, char separator) {
  if (!parse_number<double>(field)) {
    location.refuse(fmt::format("{} is not an index of a face; write '{}' or, for a position, '{}'", quoted(field),
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
  } else if (fields.size() == 3 || (fields.size() == 6 && separator == ' ')) {  // six fields: with a normal
    entry.kind = GeneratorEntry::Kind::position;
    entry.values = parse_values({fields[0], fields[1], fields[2]}, location);
    if (fields.size() == 6) parse_values({fields[3], fields[4], fields[5]}, location);
  } else {
    location.refuse(
        fmt::format("{}; write the number of a vertex, a face with coordinates '{}', or a position '{}' or '{}'",
                    counted(std::ssize(fields), "field", "fields"), spell("F b0 b1 b2", separator),
                    spell("x y z", separator), spell("p x y z", separator)));
  }
  return entry;
}

Fields split_at(std::string_view text, char separator) {
  Fields fields;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    fields.push_back(trim(text.substr(start, end - start), " \t\""));
    start = end + 1;
  }
  return fields;
}

Fields split_commas(std::string_view text) { return split_at(text, ','); }

/// The column of this name; -1 if there is none.
std::ptrdiff_t find_column(const Fields& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : found - names.begin();
}

/// The column that numbers the elements of a table: `vertex`, else `face`; -1 if there is neither.
std::ptrdiff_t find_element_column(const Fields& names) {
  const std::ptrdiff_t vertex = find_column(names, "vertex");
  return vertex >= 0 ? vertex : find_column(names, "face");
}

/// Whether a row is a header: its first field is a name, neither a number nor the `p` of a position.
bool is_header(const Fields& fields) {
  return fields[0] != "p" && !fields[0].empty() && !parse_number<double>(fields[0]);
}

/// The column of each field; -1 if the header does not have it.
struct Columns {
  std::ptrdiff_t vertex = -1, face = -1;
  std::array<std::ptrdiff_t, 3> bary{-1, -1, -1}, position{-1, -1, -1};
  std::size_t count = 0;
};

Columns read_header(const Fields& names, const ListLocation& location) {
  const auto find = [&](std::string_view name) { return find_column(names, name); };
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

/// Reads the entry of a row: the first of face, vertex and position that the row fills.
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
    if (start != end) fields.emplace_back(start, std::size_t(end - start));
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

std::vector<ListLine> split_lines(std::string_view content, std::size_t most) {
  if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
  std::vector<ListLine> lines;
  std::int32_t number = 0;
  for (std::size_t start = 0; start < content.size() && lines.size() < most;) {
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
      ListLocation{name, number}.refuse(
          "has a comma; separate the fields by blanks, or give the list as CSV with \1generators_format=csv\2");
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

std::vector<GeneratorEntry> parse_xyz(std::string_view content, const std::string& name) {
  std::vector<GeneratorEntry> entries;
  for (const auto& [text, number] : split_lines(content)) {
    const Fields fields = split_fields(text);
    const ListLocation location{name, number};
    if (fields.size() < 3)
      location.refuse(fmt::format("{} of three coordinates", counted(std::ssize(fields), "field", "fields")));
    entries.push_back(
        {GeneratorEntry::Kind::position, 0, parse_values({fields[0], fields[1], fields[2]}, location), number});
  }
  return entries;
}

std::vector<GeneratorEntry> parse_ply_points(std::string_view content, const std::string& name) {
  const std::vector<MeshProperty> columns = parse_ply_vertices(content, name);
  const auto find = [&](const char* wanted) {
    const auto found = std::ranges::find(columns, wanted, &MeshProperty::name);
    return found == columns.end() ? nullptr : &found->values;
  };
  using Columns = std::array<const std::vector<double>*, 3>;
  const std::vector<double>* const face = find("face");
  const Columns bary{find("b0"), find("b1"), find("b2")}, position{find("x"), find("y"), find("z")};
  const bool has_faces = face != nullptr && std::ranges::find(bary, nullptr) == bary.end();
  const Columns& three = has_faces ? bary : position;
  std::vector<GeneratorEntry> entries;
  for (std::size_t i = 0; i < three[0]->size(); ++i) {
    GeneratorEntry entry{has_faces ? GeneratorEntry::Kind::face : GeneratorEntry::Kind::position, 0, {}, 0};
    for (std::size_t k = 0; k < 3; ++k) entry.values[k] = (*three[k])[i];
    const bool is_finite = std::isfinite(entry.values[0] + entry.values[1] + entry.values[2]);
    const double index = has_faces ? (*face)[i] : 0;
    constexpr double kMostFaces = 2147483647;
    if (!is_finite || !(index >= 0 && index <= kMostFaces) || index != std::floor(index)) {
      ListLocation{name, 0}.refuse(fmt::format("point {} of the PLY has numbers that are not a {}", i,
                                               has_faces ? "face and coordinates in it" : "position"));
    }
    entry.index = static_cast<std::int64_t>(index);
    entries.push_back(entry);
  }
  return entries;
}

bool is_element_table(std::string_view content) {
  const std::vector<ListLine> lines = split_lines(content, 1);
  const Fields names = lines.empty() ? Fields() : split_commas(lines.front().text);
  return names.size() > 1 && is_header(names) && find_element_column(names) >= 0;
}

void refuse_other_table(std::string_view content, const std::string& name) {
  const std::vector<ListLine> lines = split_lines(content, 2);
  if (lines.empty()) return;
  const ListLine& first = lines.front();
  const auto is_name = [](std::string_view field) { return !field.empty() && !parse_number<double>(field); };
  const bool has_separators = first.text.find_first_of(",;\t") != first.text.npos;
  Fields names;
  for (const char separator : {',', ';', '\t'}) {
    if (names.size() < 2) names = split_at(first.text, separator);
  }
  if (!std::ranges::all_of(names, is_name)) return;
  const bool is_word = first.text.find(' ') == first.text.npos;
  const bool is_title = is_word && lines.size() > 1 && parse_number<double>(lines[1].text).has_value();
  if (!has_separators && !is_title) return;
  ListLocation{name, first.number}.refuse(
      "the header has no column vertex or face, with commas between columns; name the column of indices 'vertex' or "
      "'face', or give the numbers alone, in order and without a header");
}

ElementTable parse_element_table(std::string_view content, const std::string& name) {
  const std::vector<ListLine> lines = split_lines(content);
  const Fields names = split_commas(lines.front().text);
  const std::ptrdiff_t element = find_element_column(names);
  if (element < 0) ListLocation{name, lines.front().number}.refuse("the header has no column vertex or face");
  const std::string_view kind = names[element];
  ElementTable table{kind == "vertex", 0, std::vector<double>(lines.size() - 1)};
  std::ptrdiff_t last = -1;
  for (std::ptrdiff_t c = 0; c < std::ssize(names); ++c) {
    if (c == element || names[c] == "source") continue;
    last = c;
    ++table.columns;
  }
  if (last < 0) ListLocation{name, lines.front().number}.refuse("the header names no column of numbers");
  std::vector<char> is_known(table.numbers.size(), 0);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const ListLocation location{name, lines[i].number};
    const Fields fields = split_commas(lines[i].text);
    if (fields.size() != names.size()) {
      location.refuse(fmt::format("{}, but the header has {}; give as many as the header",
                                  counted(std::ssize(fields), "field", "fields"), names.size()));
    }
    const std::int64_t index = parse_index(fields[element], kind, location);
    if (index >= std::ssize(is_known)) {
      location.refuse(fmt::format("{} {} in a table of {}; each one from 0 on needs a row", kind, index,
                                  counted(std::ssize(is_known), "row", "rows")));
    }
    if (std::exchange(is_known[index], 1) != 0) location.refuse(fmt::format("{} {} has a second row", kind, index));
    const auto number = parse_number<double>(fields[last]);
    if (!number) location.refuse(fmt::format("{} is not a number", quoted(fields[last])));
    table.numbers[index] = *number;
  }
  return table;
}

}  // namespace gvd::detail
