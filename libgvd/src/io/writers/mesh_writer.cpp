// Meshes in any format: the extension picks the writer, and the arrays are checked before the first byte is written.
//
// An OBJ with labels is two files. The materials are written while the geometry is complete but has no name yet, so
// both files are complete before either gets its name.
// A format has one writer in a file of its own; none of them checks the arrays again. JSON holds a diagram, not a mesh.
// Invariant: what a format can't hold is refused by `check_format`, which a command calls before long work, too.
#include "gvd/io/mesh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/io/diagram_json.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/text.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd {
namespace {

/// In the order of OutputFormat.
constexpr std::array<std::string_view, 7> kExtensions{"ply", "obj", "off", "stl", "vtp", "glb", "json"};

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
  check_length(mesh.corner_texture, mesh.mesh.halfedge_count(), "texture coordinates of corners");
  if (mesh.properties == nullptr) return;
  for (const MeshProperty& property : *mesh.properties) {
    check_count(property.element_count(), property.of_vertices ? mesh.mesh.vertex_count() : mesh.mesh.face_count(),
                property.name.c_str());
  }
}

void write_json(std::ostream& out, const LabelledMesh& mesh) {
  if (mesh.diagram == nullptr) {
    throw Error(ErrorCode::invalid_option, "JSON holds a diagram, and there is none; choose another format");
  }
  write_diagram_json(out, mesh.diagram_mesh != nullptr ? *mesh.diagram_mesh : mesh.mesh, *mesh.diagram);
}

void write_bare_obj(std::ostream& out, const LabelledMesh& mesh) { io::write_obj(out, mesh, ""); }

/// In the order of OutputFormat.
constexpr std::array kMeshWriters{io::write_ply, write_bare_obj, io::write_off, io::write_stl,
                                  io::write_vtp, io::write_glb,  write_json};
static_assert(static_cast<std::size_t>(OutputFormat::json) + 1 == kMeshWriters.size());
static_assert(kExtensions.size() == kMeshWriters.size());

}  // namespace

std::optional<OutputFormat> parse_output_format(std::string_view extension) {
  const auto found = std::find(kExtensions.begin(), kExtensions.end(), io::bare_extension(extension));
  if (found == kExtensions.end()) return std::nullopt;
  return static_cast<OutputFormat>(found - kExtensions.begin());
}

OutputFormat output_format(const std::filesystem::path& path) {
  if (const auto format = parse_output_format(path.extension().string())) return *format;
  throw Error(ErrorCode::invalid_option, fmt::format("'{}': no output format has this extension; use one of .{}",
                                                     path.string(), fmt::join(kExtensions, ", .")));
}

void check_format(const Mesh& mesh, OutputFormat format) {
  if (format == OutputFormat::stl) io::check_single_precision(mesh, "STL");
  if (format == OutputFormat::glb) io::check_single_precision(mesh, "GLB");
}

void write_mesh(std::ostream& out, const LabelledMesh& mesh, OutputFormat format) {
  check_lengths(mesh);
  check_format(mesh.mesh, format);
  kMeshWriters[static_cast<std::size_t>(format)](out, mesh);
}

void write_mesh(const std::filesystem::path& path, const LabelledMesh& mesh, const Progress& progress) {
  const OutputFormat format = output_format(path);
  if (format != OutputFormat::obj || mesh.face_label == nullptr) {
    return write_file(
        path, [&](std::ostream& out) { write_mesh(out, mesh, format); }, progress);
  }
  const std::filesystem::path materials = std::filesystem::path(path).replace_extension(".mtl");
  const auto write_both = [&](std::ostream& out) {
    check_lengths(mesh);
    io::write_obj(out, mesh, materials.filename().string());
    write_file(
        materials, [&](std::ostream& other) { io::write_materials(other, mesh); }, progress);
  };
  write_file(path, write_both, progress);
}

}  // namespace gvd

namespace gvd::io {

std::string bare_extension(std::string_view extension) {
  return to_lower(extension.substr(extension.starts_with('.') ? 1 : 0));
}

void check_single_precision(const Mesh& mesh, std::string_view format) {
  const double largest = mesh.largest_coordinate();
  using Float = std::numeric_limits<float>;
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorCode::unwritable_output,
                fmt::format("{} holds 32-bit floats, and {}; choose PLY, OBJ, OFF or VTP", format, why));
  };
  if (largest > Float::max()) refuse(fmt::format("the coordinate {} is too large for one", largest));
  // The distance of neighbouring floats at the largest coordinate: a smaller mesh would collapse.
  const double step = std::max<double>(largest * Float::epsilon(), Float::min());
  if (mesh.bbox_diagonal() <= step) {
    refuse(fmt::format("a mesh of size {} at the coordinate {} is smaller than the step between two of them",
                       mesh.bbox_diagonal(), largest));
  }
}

}  // namespace gvd::io
