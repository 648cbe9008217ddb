#include "gvd/mesh_format.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "mesh/reading/read_off.hpp"
#include "mesh/reading/read_stl.hpp"
#include "mesh/reading/read_text.hpp"

namespace gvd {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"obj", "ply", "off", "stl"};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

// The first word of the first line that is neither blank nor a comment, within the first megabyte.
std::string first_word(std::string_view bytes) {
  TextReader text(bytes.substr(0, 1 << 20), "", true);
  return text.next_content_line() ? std::string(text.token()) : std::string();
}

// The first word of the first line is ply, as its reader demands, byte order mark and blanks included.
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

}  // namespace

std::string_view name_of(MeshFormat format) { return kNames[static_cast<std::size_t>(format)]; }

std::optional<MeshFormat> format_from_extension(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  const std::string extension = lower_case(dot == std::string_view::npos ? name : name.substr(dot + 1));
  const auto it = std::find(kNames.begin(), kNames.end(), extension);
  if (it == kNames.end()) return std::nullopt;
  return static_cast<MeshFormat>(it - kNames.begin());
}

std::optional<MeshFormat> detect_format(std::string_view bytes, std::string_view name) {
  if (is_ply(bytes)) return MeshFormat::ply;
  if (is_binary_stl(bytes)) return MeshFormat::stl;
  const std::string word = first_word(bytes);
  const std::size_t dot = name.rfind('.');
  if (is_off_keyword(word)) return MeshFormat::off;
  if (lower_case(word) == "solid") return MeshFormat::stl;
  if (is_obj_statement(word)) return MeshFormat::obj;
  return dot == std::string_view::npos ? std::nullopt : format_from_extension(name.substr(dot));
}

}  // namespace gvd
