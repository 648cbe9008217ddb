// Lists the files that a mesh file refers to, without reading the mesh.
//
// If a file is not packed, its first bytes tell its format, so a large mesh of another format is not read at all. The
// statements of an OBJ are found by searching for their keyword, which is much faster than parsing all lines.
#include "gvd/referred_files.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

namespace fs = std::filesystem;

/// How many bytes are read to tell a file's format. They suffice unless all are blank.
constexpr std::size_t kOpeningBytes = 4096;

constexpr std::string_view kLineBlanks = " \t\v\f", kLineEnds = "\r\n";

std::string read_head(const fs::path& mesh) {
  std::string head(kOpeningBytes, '\0');
  std::ifstream file(mesh, std::ios::binary);
  file.read(head.data(), std::streamsize(head.size()));
  head.resize(std::size_t(file.gcount()));
  return head;
}

/// Whether the first bytes of a file tell its format. They may not for JSON, where the key that marks a glTF can come
/// later.
bool has_telling_head(const fs::path& mesh) {
  const std::string head = read_head(mesh);
  const bool is_blank = head.find_first_not_of(" \t\r\n") == head.npos;
  return !is_blank && find_compression(head).empty() && !is_json(head) && !is_utf16(head);
}

bool may_refer(MeshFormat format) {
  return format == MeshFormat::obj || format == MeshFormat::gltf || format == MeshFormat::glb;
}

/// The arguments of the `mtllib` statements: everything after the keyword.
std::vector<std::string> find_material_statements(std::string_view obj) {
  constexpr std::string_view kKeyword = "mtllib";
  std::vector<std::string> statements;
  if (obj.starts_with("\xEF\xBB\xBF")) obj.remove_prefix(3);
  for (std::size_t at = obj.find(kKeyword); at != obj.npos; at = obj.find(kKeyword, at + 1)) {
    const std::size_t before = at == 0 ? obj.npos : obj.find_last_not_of(kLineBlanks, at - 1);
    const std::size_t begin = at + kKeyword.size();
    const bool is_first = before == obj.npos || kLineEnds.find(obj[before]) != kLineEnds.npos;
    if (!is_first || begin >= obj.size() || kLineBlanks.find(obj[begin]) == kLineBlanks.npos) continue;
    std::string_view rest = obj.substr(begin, obj.find_first_of(kLineEnds, begin) - begin);
    rest.remove_prefix(std::min(rest.find_first_not_of(kLineBlanks), rest.size()));
    statements.emplace_back(rest.substr(0, rest.find_last_not_of(kLineBlanks) + 1));
  }
  return statements;
}

}  // namespace

std::vector<fs::path> list_material_files(const fs::path& mesh, const std::vector<std::string>& statements) {
  std::vector<fs::path> files;
  for (const std::string& statement : statements) {
    if (statement.empty()) continue;
    files.emplace_back(statement);
    std::error_code ignored;
    if (fs::exists(mesh.parent_path() / statement, ignored)) continue;
    for (std::size_t at = statement.find_first_not_of(kLineBlanks); at < statement.size();) {
      const std::size_t end = std::min(statement.find_first_of(kLineBlanks, at), statement.size());
      if (end - at < statement.size()) files.emplace_back(statement.substr(at, end - at));
      at = statement.find_first_not_of(kLineBlanks, end);
    }
  }
  return files;
}

std::vector<fs::path> list_referred_files(const fs::path& mesh, std::optional<MeshFormat> format) {
  const std::string name = mesh.string();
  if (!format && has_telling_head(mesh)) format = detect_format(read_head(mesh), name);
  if (format && !may_refer(*format)) return {};
  const std::string bytes = read_file_bytes(mesh);
  if (!format) format = detect_format(bytes, name);
  if (format == MeshFormat::obj) return list_material_files(mesh, find_material_statements(bytes));
  return format && may_refer(*format) ? list_gltf_files(bytes, name) : std::vector<fs::path>();
}

}  // namespace gvd
