// Mesh files: finds the format, reads the bytes, unpacks gzip, decodes UTF-16, and hands them to the reader of the
// format.
//
// The content decides on the format before the name does, because files with a wrong extension are common. A binary STL
// has no mark of its own; its length must be the one that its triangle count asks for.
// Words decide between the text formats: OFF and solid are keywords, MNI's surfaces begin with a P and numbers, and an
// OBJ begins with one of eleven statements. So MNI's files, which are called .obj, are not taken for Wavefront's.
// Invariant: no count in a header reserves memory that the rest of the file could not fill.
#include "gvd/read_soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "gvd/error.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

constexpr std::string_view kGzipExtension = ".gz";

/// The first word of the first line that is neither blank nor a comment, within the first megabyte.
std::string first_word(std::string_view bytes) {
  TextReader text(bytes.substr(0, 1 << 20), "", true);
  return text.next_content_line() ? std::string(text.token()) : std::string();
}

/// Whether the first word of the first line is ply, as its reader demands, byte order mark and blanks included.
bool is_ply(std::string_view bytes) {
  constexpr std::string_view kBlanks = " \t\v\f";
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(kBlanks), bytes.size()));
  return bytes.size() > 3 && bytes.starts_with("ply") && std::string_view(" \t\v\f\r\n").find(bytes[3]) != bytes.npos;
}

bool is_obj_statement(std::string_view word) {
  constexpr std::array<std::string_view, 11> kStatements = {"v", "vn",     "vt",     "vp", "f", "o",
                                                            "g", "mtllib", "usemtl", "s",  "l"};
  return std::find(kStatements.begin(), kStatements.end(), word) != kStatements.end();
}

[[noreturn]] void refuse(std::string_view name, std::string_view message) {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name, message));
}

/// Refuses content that is known and no mesh, whatever the name or the user says.
void refuse_foreign(std::string_view bytes, std::string_view name) {
  const std::string content = describe_content(bytes);
  if (!content.empty()) refuse(name, "the file is " + content);
}

/// Unpacks the bytes of a gzip file, and decodes text in UTF-16; leaves others as they are.
void unpack(std::string& bytes, std::string_view name) {
  if (is_gzip(bytes)) bytes = unpack_gzip(bytes, name);
  if (is_utf16(bytes)) bytes = to_utf8(bytes);
}

/// Calls parse(content) with bytes as `unpack` makes them, which are copied only where they change.
template <class Parse>
auto with_unpacked(std::string_view bytes, std::string_view name, const Parse& parse) {
  if (!is_gzip(bytes) && !is_utf16(bytes)) return parse(bytes);
  std::string content(bytes);
  unpack(content, name);
  return parse(std::string_view(content));
}

/// Says what a file has, which is no surface.
[[noreturn]] void refuse_faceless(const PolygonSoup& soup, std::string_view bytes, MeshFormat format,
                                  std::string_view name) {
  const auto vertices = std::ssize(soup.positions);
  if (vertices == 0 && soup.notes.empty() && format == MeshFormat::obj) {  // skips what it does not know
    const std::string word = first_word(bytes);
    refuse(name, fmt::format("as an OBJ, the file has neither a vertex nor a face, and it {}; name the format with {}",
                             word.empty() ? std::string("is blank") : "begins with " + gvd::quoted(word),
                             input_format_option()));
  }
  if (vertices == 0 && soup.notes.empty()) refuse(name, "the file has no vertex and no face; a surface is needed");
  refuse(name,
         fmt::format("the file has {} and no face; a surface is needed{}", counted(vertices, "vertex", "vertices"),
                     soup.notes.empty() ? "" : fmt::format(" ({})", fmt::join(soup.notes, "; "))));
}

/// `folder`: where the buffers of a glTF may be.
PolygonSoup parse_unpacked(std::string_view bytes, MeshFormat format, std::string_view name,
                           const std::optional<std::filesystem::path>& folder) {
  if (bytes.empty()) refuse(name, "the file is empty");
  refuse_foreign(bytes, name);
  const auto read = [&] {
    switch (format) {
      case MeshFormat::obj:
        return parse_obj(bytes, name);
      case MeshFormat::ply:
        return parse_ply(bytes, name);
      case MeshFormat::off:
        return parse_off(bytes, name);
      case MeshFormat::stl:
        return parse_stl(bytes, name);
      case MeshFormat::vtp:
      case MeshFormat::vtu:
        return parse_vtk_xml(bytes, name);
      case MeshFormat::vtk:
        return parse_vtk(bytes, name);
      case MeshFormat::glb:
      case MeshFormat::gltf:
        return parse_gltf(bytes, name, folder);
      case MeshFormat::gii:
        return parse_gifti(bytes, name);
      case MeshFormat::mni:
        return parse_mni(bytes, name);
      case MeshFormat::fs:
        return parse_freesurfer(bytes, name);
    }
    return PolygonSoup();
  };
  PolygonSoup soup = read();
  if (soup.polygon_count() == 0) refuse_faceless(soup, bytes, format, name);
  check_counts(soup.positions.size(), soup.polygon_count(), name);
  return soup;
}

/// The format that the content has a mark of.
std::optional<MeshFormat> find_format(std::string_view bytes) {
  if (is_ply(bytes)) return MeshFormat::ply;
  if (bytes.starts_with("glTF")) return MeshFormat::glb;
  if (bytes.starts_with("# vtk DataFile")) return MeshFormat::vtk;
  if (bytes.starts_with(kFreeSurferSurface)) return MeshFormat::fs;
  if (is_xml_of(bytes, "<VTKFile")) return is_xml_of(bytes, "UnstructuredGrid") ? MeshFormat::vtu : MeshFormat::vtp;
  if (is_xml_of(bytes, "<GIFTI")) return MeshFormat::gii;
  if (is_binary_stl(bytes)) return MeshFormat::stl;
  if (is_json(bytes) && bytes.find("\"asset\"") != bytes.npos) return MeshFormat::gltf;
  if (is_mni(bytes)) return MeshFormat::mni;
  const std::string word = first_word(bytes);
  if (is_off_keyword(word)) return MeshFormat::off;
  if (to_lower(word) == "solid") return MeshFormat::stl;
  return is_obj_statement(word) ? std::optional(MeshFormat::obj) : std::nullopt;
}

}  // namespace

std::string input_format_option() {
  std::string names;
  for (std::size_t i = 0; i < kMeshFormatNames.size(); ++i) {
    names += i == 0 ? "" : i + 1 < kMeshFormatNames.size() ? ", " : " or ";
    names += kMeshFormatNames[i].first;
  }
  return "{option:input_format=" + names + '}';
}

std::optional<MeshFormat> format_from_extension(std::string_view name) {
  if (to_lower(name).ends_with(kGzipExtension)) name.remove_suffix(kGzipExtension.size());
  const std::size_t dot = name.rfind('.');
  return value_in(kMeshFormatNames, to_lower(dot == name.npos ? name : name.substr(dot + 1)));
}

bool is_xml_of(std::string_view bytes, std::string_view element) {
  constexpr std::size_t kSearched = 4096;
  bytes = bytes.substr(0, kSearched);
  const std::size_t first = bytes.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return first != bytes.npos && bytes[first] == '<' && bytes.find(element) != bytes.npos;
}

bool is_json(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  return first != bytes.npos && bytes[first] == '{';
}

std::string read_file_bytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse(name, "there is no such file");
  if (status.type() == std::filesystem::file_type::directory) refuse(name, "this is a directory; give a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(name, "the file can't be opened; check its permissions");
  const std::uintmax_t size = std::filesystem::file_size(path, error);  // fails for a pipe
  std::string bytes = read_to_end(file, error ? 0 : size);
  if (file.bad()) refuse(name, "the file can't be read to its end");
  unpack(bytes, name);
  return bytes;
}

std::optional<MeshFormat> detect_format(std::string_view bytes, std::string_view name) {
  const auto found = is_utf16(bytes) ? find_format(to_utf8(bytes)) : find_format(bytes);
  if (found) return found;
  return name.find('.') == name.npos ? std::nullopt : format_from_extension(name);
}

void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name) {
  if (std::max(vertices, polygons) <= kMostVertices) return;
  throw Error(ErrorCode::precondition,
              fmt::format("{}: {} vertices and {} faces are more than 32-bit ids can count ({}); simplify the mesh",
                          name, vertices, polygons, kMostVertices));
}

PolygonSoup make_soup(std::span<const double> coordinates, std::span<const std::int64_t> corners, std::size_t size) {
  PolygonSoup soup;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    soup.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  for (const std::int64_t v : corners) {
    if (v < 0 || v >= std::ssize(soup.positions)) {
      const auto face = std::int64_t(soup.polygon_count());
      throw Error(
          ErrorCode::precondition,
          fmt::format("face {} has the vertex {}; there are {}, numbered from 0", face, v, soup.positions.size()),
          face);
    }
    soup.corners.push_back(std::int32_t(v));
    if (soup.corners.size() % size == 0) soup.close_polygon();
  }
  return soup;
}

PolygonSoup parse_soup(std::string_view bytes, MeshFormat format, std::string_view name) {
  return with_unpacked(bytes, name,
                       [&](std::string_view content) { return parse_unpacked(content, format, name, std::nullopt); });
}

PolygonSoup read_soup(const std::filesystem::path& path, std::optional<MeshFormat> format) {
  const std::string name = path.string();
  const std::string bytes = read_file_bytes(path);
  if (bytes.empty()) refuse(name, "the file is empty");
  if (!format) format = detect_format(bytes, name);
  if (!format) {
    refuse_foreign(bytes, name);
    refuse(name,
           "neither the name nor the content is that of an OBJ, PLY, OFF, STL, VTP, VTU, VTK, glTF, GIFTI, MNI or "
           "FreeSurfer file; name the format with " +
               input_format_option());
  }
  std::error_code ignored;
  const bool has_folder = std::filesystem::is_regular_file(path, ignored);  // which a pipe has not
  return parse_unpacked(bytes, *format, name, has_folder ? std::optional(path.parent_path()) : std::nullopt);
}

std::optional<SoupProperty> read_soup_property(const std::filesystem::path& path, std::string_view property,
                                               SoupElement preferred) {
  const std::string name = path.string();
  const std::string bytes = read_file_bytes(path);
  const auto format = bytes.empty() ? std::nullopt : detect_format(bytes, name);
  if (format == MeshFormat::vtp || format == MeshFormat::vtu) {
    return parse_vtk_xml_property(bytes, property, name, preferred);
  }
  return format == MeshFormat::ply ? parse_ply_property(bytes, property, name, preferred) : std::nullopt;
}

std::vector<MeshProperty> parse_mesh_properties(std::string_view bytes, MeshFormat format, std::string_view name) {
  return with_unpacked(bytes, name, [&](std::string_view content) {
    if (format == MeshFormat::obj) return parse_obj_colors(content, name);
    return format == MeshFormat::ply ? parse_ply_properties(content, name) : std::vector<MeshProperty>();
  });
}

std::vector<MeshProperty> read_mesh_properties(const std::filesystem::path& path, std::optional<MeshFormat> format) {
  const std::string name = path.string();
  const std::string bytes = read_file_bytes(path);
  if (!format) format = detect_format(bytes, name);
  return format ? parse_mesh_properties(bytes, *format, name) : std::vector<MeshProperty>();
}

}  // namespace gvd
