#include "gvd/read_soup.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "gvd/counted.hpp"
#include "gvd/error.hpp"
#include "mesh/reading/check_counts.hpp"
#include "mesh/reading/read_obj.hpp"
#include "mesh/reading/read_off.hpp"
#include "mesh/reading/read_ply.hpp"
#include "mesh/reading/read_stl.hpp"

namespace gvd {
namespace {

[[noreturn]] void refuse(std::string_view name, std::string_view message) {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name, message));
}

// Reads the file at once if its size is known, and in pieces if it is a pipe.
std::string read_bytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse(name, "there is no such file");
  if (status.type() == std::filesystem::file_type::directory) refuse(name, "this is a directory; give a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(name, "the file can't be opened; check its permissions");
  std::string bytes;
  if (status.type() == std::filesystem::file_type::regular) {
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error) bytes.resize(static_cast<std::size_t>(size));
  }
  std::size_t filled = 0;
  for (;;) {
    constexpr std::size_t kPiece = 1 << 16;
    if (filled == bytes.size()) bytes.resize(bytes.size() + kPiece + bytes.size() / 2);
    file.read(bytes.data() + filled, static_cast<std::streamsize>(bytes.size() - filled));
    filled += static_cast<std::size_t>(file.gcount());
    if (file.bad()) refuse(name, "the file can't be read to its end");
    if (!file) break;
    if (file.peek() == std::ifstream::traits_type::eof()) break;
  }
  bytes.resize(filled);
  return bytes;
}

PolygonSoup parse_format(std::string_view bytes, MeshFormat format, std::string_view name) {
  switch (format) {
    case MeshFormat::obj:
      return parse_obj(bytes, name);
    case MeshFormat::ply:
      return parse_ply(bytes, name);
    case MeshFormat::off:
      return parse_off(bytes, name);
    case MeshFormat::stl:
      return parse_stl(bytes, name);
  }
  throw Error(ErrorCode::invalid_option, "the mesh format is none of obj, ply, off and stl");
}

}  // namespace

PolygonSoup parse_soup(std::string_view bytes, MeshFormat format, std::string_view name) {
  if (bytes.empty()) refuse(name, "the file is empty");
  PolygonSoup soup = parse_format(bytes, format, name);
  if (soup.polygon_count() == 0) {
    refuse(name, fmt::format("the file has {} and no face; a surface is needed",
                             counted(std::ssize(soup.positions), "vertex", "vertices")));
  }
  check_counts(soup.positions.size(), soup.polygon_count(), name);
  return soup;
}

std::optional<SoupProperty> read_soup_property(const std::filesystem::path& path, std::string_view property) {
  const std::string name = path.string();
  const std::string bytes = read_bytes(path);
  if (bytes.empty() || detect_format(bytes, name) != MeshFormat::ply) return std::nullopt;
  return parse_ply_property(bytes, property, name);
}

MeshAttributes parse_mesh_attributes(std::string_view bytes, MeshFormat format, std::string_view name) {
  if (format == MeshFormat::ply) return parse_ply_attributes(bytes, name);
  if (format == MeshFormat::obj) return {{}, parse_obj_texture(bytes, name)};
  return {};
}

MeshAttributes read_mesh_attributes(const std::filesystem::path& path, std::optional<MeshFormat> format) {
  const std::string name = path.string();
  const std::string bytes = read_bytes(path);
  if (!format) format = detect_format(bytes, name);
  return format ? parse_mesh_attributes(bytes, *format, name) : MeshAttributes();
}

PolygonSoup read_soup(const std::filesystem::path& path, std::optional<MeshFormat> format) {
  const std::string name = path.string();
  const std::string bytes = read_bytes(path);
  if (bytes.empty()) refuse(name, "the file is empty");
  if (!format) format = detect_format(bytes, name);
  if (!format)
    refuse(name, "neither the name nor the first line is that of an OBJ, PLY, OFF or STL file; name the format");
  return parse_soup(bytes, *format, name);
}

}  // namespace gvd
