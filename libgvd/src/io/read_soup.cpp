// Reads mesh files: finds the format, and passes the unpacked bytes to the reader in the format's row of the table.
//
// The content decides on the format before the name does, because files with a wrong extension are common.
// Invariant: no count in a header reserves memory that the rest of the file could not fill.
#include "gvd/read_soup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

constexpr std::string_view kGzipExtension = ".gz";

[[noreturn]] void refuse_file(std::string_view name, std::string_view message) {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name, message));
}

/// Refuses content of a known kind that is no mesh, whatever the name or the user says.
void refuse_foreign_file(std::string_view bytes, std::string_view name) {
  const std::string content = describe_content(bytes);
  if (!content.empty()) refuse_file(name, "the file is " + content);
}

/// Calls parse(content) with the bytes after `unpack`, which are copied only if unpacking changes them.
template <class Parse>
auto with_unpacked(std::string_view bytes, std::string_view name, const Parse& parse) {
  if (!is_gzip(bytes) && !is_utf16(bytes)) return parse(bytes);
  std::string content(bytes);
  unpack(content, name);
  return parse(std::string_view(content));
}

/// Refuses a file without faces, and says what it has instead.
[[noreturn]] void refuse_faceless(const PolygonSoup& soup, std::string_view bytes, MeshFormat format,
                                  std::string_view name) {
  const auto vertices = std::ssize(soup.positions);
  // The reader of OBJ skips statements that it does not know.
  if (vertices == 0 && soup.notes.empty() && format == MeshFormat::obj) {
    const std::string word = first_word(bytes);
    refuse_file(name,
                fmt::format("as an OBJ, the file has neither a vertex nor a face, and it {}; name the format with {}",
                            word.empty() ? std::string("is blank") : "begins with " + gvd::quoted(word),
                            input_format_option()));
  }
  if (vertices == 0 && soup.notes.empty()) refuse_file(name, "the file has no vertex and no face; a surface is needed");
  refuse_file(name,
              fmt::format("the file has {} and no face; a surface is needed{}", counted(vertices, "vertex", "vertices"),
                          soup.notes.empty() ? "" : fmt::format(" ({})", fmt::join(soup.notes, "; "))));
}

/// `folder`: where the buffers of a glTF may lie.
PolygonSoup parse_unpacked(std::string_view bytes, MeshFormat format, std::string_view name,
                           const std::optional<std::filesystem::path>& folder) {
  if (bytes.empty()) refuse_file(name, "the file is empty");
  refuse_foreign_file(bytes, name);
  const Format& row = format_row(format);
  if (row.read == nullptr) refuse_file(name, fmt::format("no mesh is read from .{}; name another format", row.name));
  PolygonSoup soup = row.read(bytes, name, folder);
  if (soup.polygon_count() == 0) refuse_faceless(soup, bytes, format, name);
  check_counts(soup.positions.size(), soup.polygon_count(), name);
  return soup;
}

/// The format whose mark the content has.
std::optional<MeshFormat> find_format(std::string_view bytes) {
  for (const Format& format : formats()) {
    if (format.is_content != nullptr && format.is_content(bytes)) return format.id;
  }
  return std::nullopt;
}

/// The names of all formats that can be read.
std::vector<std::string_view> list_titles() {
  std::vector<std::string_view> titles;
  for (const Format& format : formats()) {
    if (format.read != nullptr) titles.push_back(format.title);
  }
  return titles;
}

/// The format of a file. Refuses a file of no known format.
MeshFormat require_format(std::string_view bytes, std::string_view name) {
  if (bytes.empty()) refuse_file(name, "the file is empty");
  if (const auto format = detect_format(bytes, name)) return *format;
  refuse_foreign_file(bytes, name);
  refuse_file(name, fmt::format("neither the name nor the content is that of a {} file; name the format with {}",
                                join_words(list_titles(), "or"), input_format_option()));
}

}  // namespace

std::string input_format_option() {
  return placeholder("input_format", join_words(names_in(input_format_names()), "or"));
}

std::optional<MeshFormat> format_from_extension(std::string_view name) {
  if (to_lower(name).ends_with(kGzipExtension)) name.remove_suffix(kGzipExtension.size());
  const std::size_t dot = name.rfind('.');
  const std::string extension = to_lower(dot == name.npos ? name : name.substr(dot + 1));
  for (const Format& format : formats()) {
    if (format.read == nullptr) continue;
    for (const auto* const extensions : {&format.extensions, &format.input_extensions}) {
      if (std::ranges::find(*extensions, extension) != extensions->end()) return format.id;
    }
  }
  return std::nullopt;
}

std::optional<MeshFormat> detect_format(std::string_view bytes, std::string_view name) {
  const auto found = is_utf16(bytes) ? find_format(to_utf8(bytes)) : find_format(bytes);
  if (found) return found;
  return name.find('.') == name.npos ? std::nullopt : format_from_extension(name);
}

PolygonSoup parse_soup(std::string_view bytes, std::optional<MeshFormat> format, std::string_view name) {
  return with_unpacked(bytes, name, [&](std::string_view content) {
    return parse_unpacked(content, format ? *format : require_format(content, name), name, std::nullopt);
  });
}

PolygonSoup read_soup(const std::filesystem::path& path, std::optional<MeshFormat> format) {
  const std::string name = path.string();
  const std::string bytes = read_file_bytes(path);
  if (!format) format = require_format(bytes, name);
  std::error_code ignored;
  const bool has_folder = std::filesystem::is_regular_file(path, ignored);  // a pipe has no folder
  return parse_unpacked(bytes, *format, name, has_folder ? std::optional(path.parent_path()) : std::nullopt);
}

std::optional<SoupProperty> read_soup_property(const std::filesystem::path& path, std::string_view property,
                                               SoupElement preferred) {
  const std::string name = path.string();
  const std::string bytes = read_file_bytes(path);
  const auto format = bytes.empty() ? std::nullopt : detect_format(bytes, name);
  const auto read = format ? format_row(*format).read_property : nullptr;
  return read == nullptr ? std::nullopt : read(bytes, property, name, preferred);
}

std::vector<MeshProperty> parse_mesh_properties(std::string_view bytes, MeshFormat format, std::string_view name) {
  const auto read = format_row(format).read_properties;
  if (read == nullptr) return {};
  return with_unpacked(bytes, name, [&](std::string_view content) { return read(content, name); });
}

std::vector<MeshProperty> read_mesh_properties(const std::filesystem::path& path, std::optional<MeshFormat> format) {
  const std::string name = path.string();
  const std::string bytes = read_file_bytes(path);
  if (!format) format = detect_format(bytes, name);
  return format ? parse_mesh_properties(bytes, *format, name) : std::vector<MeshProperty>();
}

}  // namespace gvd
