// Lists that are written line by line: their lines, fields and entries, and the list as text.
//
// An entry says by the number of its fields what it is: one is a vertex, four a face with coordinates or a position
// behind `p`, three a position. Whether three whole numbers are a position or three vertices only the whole list tells.
// Invariant: a list that could be read in two ways is refused, never guessed at. Every message names list and line.
#include "io/parse_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::detail {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Whether the three fields are different indices. Coordinates are seldom all whole, not negative and different.
bool could_be_vertices(const std::vector<std::string_view>& fields) {
  std::array<std::int64_t, 3> indices{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto index = parse_field<std::int64_t>(fields[i]);
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
  if (!parse_field<double>(field)) {
    location.refuse(fmt::format("{} is no index of a face; write '{}' or, for a position, '{}'", quoted(field),
                                spell("F b0 b1 b2", separator), spell("p x y z", separator)));
  }
  return parse_index(field, "face", location);
}

GeneratorEntry parse_entry(const std::vector<std::string_view>& fields, const ListLocation& location, char separator) {
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

}  // namespace

std::string read_list_file(const std::filesystem::path& path, std::string_view what) {
  const auto refuse = [&](std::string_view message) {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", path.string(), message));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(fmt::format("is a directory; name a list of {}", what));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(fmt::format("{}; name a list of {}", std::strerror(errno), what));
  std::string content = read_to_end(file);
  if (file.bad()) refuse("could not be read to its end");
  return content;
}

std::string ListLocation::text() const { return line > 0 ? fmt::format("{}:{}", name, line) : name; }

void ListLocation::refuse(const std::string& message) const {
  throw Error(ErrorCode::unreadable_input, text() + ": " + message, line > 0 ? line - 1 : -1);
}

std::vector<std::string_view> split_fields(std::string_view text, char separator) {
  const auto is_between = [separator](char c) { return c == separator || kBlanks.find(c) != kBlanks.npos; };
  std::vector<std::string_view> fields;
  for (auto start = text.begin(); start != text.end();) {
    start = std::find_if_not(start, text.end(), is_between);
    const auto end = std::find_if(start, text.end(), is_between);
    if (start != end) fields.emplace_back(start, end);
    start = end;
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

}  // namespace gvd::detail
