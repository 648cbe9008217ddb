// Writes meshes in any format. The extension selects the row of the table, and the arrays are checked before the first
// byte is written.
//
// An OBJ with materials of regions is two files. The materials are written when the geometry is complete but has no
// name yet, so both files are complete before either gets its name.
// Invariant: `check_format` refuses everything that a format can't hold, so no writer checks the arrays again. Commands
// also call it before long work.
#include "gvd/io/mesh_writer.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/text.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd {
namespace {

void check_count(std::size_t count, std::int32_t expected, const char* what) {
  if (std::cmp_equal(count, expected)) return;
  throw Error(ErrorCode::precondition,
              fmt::format("{}: {} for {}; give one for each", what, counted(std::int64_t(count), "value", "values"),
                          counted(expected, "element", "elements")));
}

template <class Array>
void check_length(const Array* values, std::int32_t expected, const char* what) {
  if (values != nullptr) check_count(values->size(), expected, what);
}

void check_lengths(const LabelledMesh& mesh) {
  check_length(mesh.face_label, mesh.mesh.face_count(), "face labels");
  check_length(mesh.face_parent, mesh.mesh.face_count(), "parent faces");
  check_length(mesh.vertex_label, mesh.mesh.vertex_count(), "vertex labels");
  check_length(mesh.vertex_distance, mesh.mesh.vertex_count(), "vertex distances");
  if (mesh.has_texture()) check_length(&mesh.appearance->texture, mesh.mesh.halfedge_count(), "texture coordinates");
  if (mesh.names_materials()) check_length(&mesh.appearance->material, mesh.mesh.face_count(), "materials of faces");
  if (mesh.face_numbers != nullptr) {
    for (const FaceNumbers& numbers : *mesh.face_numbers) {
      check_length(&numbers.values, mesh.mesh.face_count(), numbers.name.c_str());
    }
  }
  if (mesh.properties == nullptr) return;
  for (const MeshProperty& property : *mesh.properties) {
    check_count(property.element_count(), property.of_vertices ? mesh.mesh.vertex_count() : mesh.mesh.face_count(),
                property.name.c_str());
  }
}

/// The point that a format's positions are relative to.
Vec3 origin_in(const Mesh& mesh, const Format& format) {
  return has_any(format.carries, Content::place) ? io::glb_translation(mesh) : Vec3(Vec3::Zero());
}

}  // namespace

std::string format_extension(const std::filesystem::path& path) {
  const std::string name = to_lower(path.filename().string());
  std::string_view longest, stands_for;
  for (const Format& format : formats()) {
    if (!format.is_output()) continue;
    for (const std::string& extension : format.extensions) {
      const bool is_last = name.size() > extension.size() + 1 && name.ends_with("." + extension);
      if (is_last && extension.size() > longest.size()) longest = extension, stands_for = format.extensions.front();
    }
  }
  return longest.empty() ? io::bare_extension(path.extension().string()) : std::string(stands_for);
}

std::optional<MeshFormat> parse_output_format(std::string_view extension) {
  const Format* const found = find_output(extension);
  return found != nullptr && found->write != nullptr ? std::optional(found->id) : std::nullopt;
}

MeshFormat output_format(const std::filesystem::path& path) {
  if (const auto format = parse_output_format(format_extension(path))) return *format;
  std::vector<std::string> known;
  for (const Format& format : formats()) {
    if (format.write != nullptr) known.push_back(format.extensions.front());
  }
  throw Error(ErrorCode::invalid_option, fmt::format("'{}': no output format has this extension; use one of {}",
                                                     path.string(), list_extensions(known, "or")));
}

std::optional<std::filesystem::path> materials_file(const std::filesystem::path& path) {
  const Format* const format = find_output(format_extension(path));
  if (format == nullptr || !has_any(format->carries, Content::materials)) return std::nullopt;
  return std::filesystem::path(path).replace_extension(".mtl");
}

void check_format(const Mesh& mesh, MeshFormat id) {
  const Format& format = format_row(id);
  if (has_any(format.carries, Content::doubles) || !has_any(format.carries, Content::surface | Content::distances))
    return;
  const std::string why = io::why_not_floats(mesh, origin_in(mesh, format));
  if (why.empty()) return;
  throw Error(ErrorCode::unwritable_output,
              fmt::format(".{} holds 32-bit floats, and {}; choose {}", format.extensions.front(), why,
                          list_extensions(output_extensions(Content::doubles), "or")));
}

PositionLoss measure_position_loss(const Mesh& mesh, MeshFormat id) {
  const Format& format = format_row(id);
  const bool has_floats = has_any(format.carries, Content::surface) && !has_any(format.carries, Content::doubles);
  return has_floats ? io::measure_float_loss(mesh, origin_in(mesh, format)) : PositionLoss();
}

void write_mesh(std::ostream& out, const LabelledMesh& mesh, MeshFormat id) {
  const Format& format = format_row(id);
  if (format.write == nullptr) {
    throw Error(ErrorCode::invalid_option, fmt::format("a mesh can't be written as .{}; choose {}", format.name,
                                                       list_extensions(output_extensions(Content::surface), "or")));
  }
  check_lengths(mesh);
  check_format(mesh.mesh, id);
  format.write(out, io::ColoredMesh(mesh));
}

void write_mesh(const std::filesystem::path& path, const LabelledMesh& mesh, const Progress& progress) {
  const MeshFormat format = output_format(path);
  const auto materials = materials_file(path);
  if (!materials || mesh.face_label == nullptr || mesh.names_materials()) {
    return write_file(
        path, [&](std::ostream& out) { write_mesh(out, mesh, format); }, progress);
  }
  const auto write_both = [&](std::ostream& out) {
    check_lengths(mesh);
    io::write_obj_with_library(out, mesh, materials->filename().string());
    write_file(
        *materials, [&](std::ostream& other) { io::write_materials(other, io::ColoredMesh(mesh)); }, progress);
  };
  write_file(path, write_both, progress);
}

}  // namespace gvd
