// Meshes in any format: the extension picks the writer, and the arrays are checked before the first byte is written.
// OBJ, OFF and STL are written here; PLY, VTP and GLB in files of their own.
//
// OBJ: a region is a group with a material, unless the faces have materials of their own, whose names then stay.
// Bisectors are lines, whose vertices follow those of the mesh, so the numbers of the mesh's vertices are those of the
// input, with and without bisectors, groups and texture. OBJ counts from 1, and shares texture coordinates between
// faces by number. With materials of regions it is two files. These are written while the geometry is complete but has
// no name yet, so both files are complete before either gets its name.
//
// OFF has no colours: meshio reads exactly three numbers of a vertex and four of a face. COFF has four numbers from 0
// to 1 behind each vertex, as Geomview specifies, and three from 0 to 255 behind each face. OFF with colours of faces
// only is valid too, but OpenMesh reads these as the next face.
//
// STL, binary: 80 bytes of header, the number of triangles, and for each its normal, its corners and an attribute: 50
// bytes, so that readers tell it from text by its length. STL has neither shared vertices nor labels. The colour of a
// label goes into the attribute, by the convention of VisCAM and SolidView that most programs read.
//
// JSON holds a diagram, `gvd-diagram/1`, not a mesh: every element on a line of its own, in the order of the ids. The
// text is printed piece by piece instead of built as a document, so memory does not grow with the diagram. Infinity and
// NaN, which JSON does not have, are null; numbers bring the same double back.
// Source: Wavefront's Advanced Visualizer manual, appendix B1, for the statements v, vt, f, l, g, mtllib and usemtl; the
// Geomview manual, section OFF; 3D Systems' StereoLithography Interface Specification, for all but the colours.
// Invariant: what a format can't hold is refused by `check_format`, which a command calls before long work, too. No
// writer checks the arrays again.
#include "gvd/io/mesh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/io/diagram_json.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/text.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

void print_vertex(ByteWriter& out, const Vec3& p) { out.print("v {} {} {}\n", p.x(), p.y(), p.z()); }

/// Texture coordinates of a vertex that another one is compared with, the last ones: the tip of a cone may have many.
constexpr std::ptrdiff_t kComparedTexture = 64;

/// Writes the coordinates of corners, equal ones of a vertex once. Gives their number for each corner, from 1; none
/// without a texture.
std::vector<std::size_t> print_texture(ByteWriter& out, const LabelledMesh& mesh) {
  std::vector<std::size_t> numbers;
  if (!mesh.has_texture()) return numbers;
  using Numbered = std::pair<Uv, std::size_t>;
  IdVector<VertexId, std::vector<Numbered>> known(mesh.mesh.vertex_count());
  std::size_t count = 0;
  for (const HalfedgeId h : mesh.mesh.halfedges()) {
    const Uv& uv = mesh.appearance->texture[h.index()];
    std::vector<Numbered>& at = known[mesh.mesh.from(h)];
    auto found = std::find_if(at.end() - std::min(std::ssize(at), kComparedTexture), at.end(),
                              [&](const Numbered& n) { return n.first == uv; });
    if (found == at.end() && std::isfinite(uv[0]) && std::isfinite(uv[1])) {
      out.print("vt {} {}\n", uv[0], uv[1]);
      found = at.insert(at.end(), {uv, ++count});
    }
    numbers.push_back(found == at.end() ? 0 : found->second);
  }
  return numbers;
}

/// Prints the faces, with the numbers of their texture coordinates and the names of their materials.
class FacePrinter {
 public:
  /// `texture`: what print_texture gave.
  FacePrinter(ByteWriter& out, const LabelledMesh& mesh, std::vector<std::size_t> texture)
      : out_(out), mesh_(mesh), texture_(std::move(texture)) {}

  /// In the order of the faces.
  void print_all() {
    for (const FaceId f : mesh_.mesh.faces()) print(f);
  }

  /// Group by group. `with_materials`: each region has one of its own, and the faces have none.
  void print_regions(bool with_materials) {
    for (const Region& region : collect_regions(mesh_)) {
      const std::string name = region_name(region.label);
      out_.print("g {}\n", name);
      if (with_materials) out_.print("usemtl {}\n", name);
      for (const FaceId f : region.faces) print(f);
    }
  }

 private:
  void print(FaceId f) {
    if (mesh_.names_materials()) use_material(mesh_.appearance->material[f.index()]);
    const auto& [a, b, c] = mesh_.mesh.vertices(f);
    const std::size_t* t = texture_.empty() ? nullptr : texture_.data() + 3 * f.index();
    if (t == nullptr || t[0] == 0 || t[1] == 0 || t[2] == 0) {
      out_.print("f {} {} {}\n", a.value() + 1, b.value() + 1, c.value() + 1);
    } else {
      out_.print("f {}/{} {}/{} {}/{}\n", a.value() + 1, t[0], b.value() + 1, t[1], c.value() + 1, t[2]);
    }
  }

  /// A statement holds for all faces up to the next one.
  void use_material(std::int32_t material) {
    if (material == material_) return;
    material_ = material;
    out_.print("usemtl {}\n", material < 0 ? kNoMaterial : std::string_view(mesh_.appearance->materials[material]));
  }

  ByteWriter& out_;
  const LabelledMesh& mesh_;
  std::vector<std::size_t> texture_;
  std::int32_t material_ = -1;  // that of the last statement; faces before the first one have none
};

/// The line through the vertices from number `first` on, one `l` for each segment: Blender keeps one edge of a longer
/// `l`.
/// Returns the number after the last vertex.
std::size_t print_line(ByteWriter& out, const OutputLine& line, std::size_t first) {
  if (line.left.valid()) out.print("# left {} right {}\n", line.left.value(), line.right.value());
  for (const Vec3& p : line.points) print_vertex(out, p);
  const std::size_t last = first + line.points.size() - 1;
  for (std::size_t i = first; i < last; ++i) out.print("l {} {}\n", i, i + 1);
  return last + 1;
}

/// The vertices of the lines follow those of the mesh, whose numbers do not change. Bisectors and curves are objects
/// of their own: Blender would add them to the mesh as loose edges.
void print_lines(ByteWriter& out, const LabelledMesh& mesh) {
  std::size_t index = mesh.mesh.positions().size() + 1;
  std::string object, group;
  for (const OutputLine& line : collect_lines(mesh)) {
    const char* const kind = line.left.valid() ? "bisectors" : "curves";
    if (kind != object) out.print("o {}\n", object = kind);
    if (line.group != group) out.print("g {}\n", group = line.group);
    index = print_line(out, line, index);
  }
}

/// OBJ: a group for each region, and the bisectors as lines. `material_library` is the file name of the .mtl of the
/// regions; empty for none.
void write_obj(std::ostream& stream, const LabelledMesh& mesh, const std::string& material_library) {
  ByteWriter out(stream);
  if (!material_library.empty()) out.print("mtllib {}\n", material_library);
  if (mesh.names_materials()) {
    for (const std::string& file : mesh.appearance->material_files) out.print("mtllib {}\n", file);
  }
  for (const Vec3& p : mesh.mesh.positions()) print_vertex(out, p);
  FacePrinter faces(out, mesh, print_texture(out, mesh));
  mesh.face_label != nullptr ? faces.print_regions(!material_library.empty()) : faces.print_all();
  print_lines(out, mesh);
  out.finish();
}

/// Writes the .mtl of an OBJ: one material for each region.
void write_materials(std::ostream& stream, const ColoredMesh& mesh) {
  ByteWriter out(stream);
  for (const Region& region : collect_regions(mesh)) {
    const std::array<double, 3> color = to_linear(mesh.color(region.label));
    out.print("newmtl {}\nKd {:.4f} {:.4f} {:.4f}\n", region_name(region.label), color[0], color[1], color[2]);
  }
  out.finish();
}

GeneratorId vertex_label(const LabelledMesh& labelled, VertexId v) {
  if (labelled.vertex_label != nullptr) return (*labelled.vertex_label)[v];
  return (*labelled.face_label)[Mesh::face(labelled.mesh.halfedge(v))];
}

void print_off_vertices(ByteWriter& out, const ColoredMesh& labelled) {
  for (const VertexId v : labelled.mesh.vertices()) {
    const Vec3& p = labelled.mesh.position(v);
    out.print("{} {} {}", p.x(), p.y(), p.z());
    if (labelled.face_label != nullptr) {
      const Rgb color = labelled.color(vertex_label(labelled, v));
      out.print(" {:.4f} {:.4f} {:.4f} 1.0", color.red / 255.0, color.green / 255.0, color.blue / 255.0);
    }
    out.text("\n");
  }
}

void print_off_faces(ByteWriter& out, const ColoredMesh& labelled) {
  for (const FaceId f : labelled.mesh.faces()) {
    const auto& [a, b, c] = labelled.mesh.vertices(f);
    out.print("3 {} {} {}", a.value(), b.value(), c.value());
    if (labelled.face_label != nullptr) {
      const Rgb color = labelled.color((*labelled.face_label)[f]);
      out.print(" {} {} {}", color.red, color.green, color.blue);
    }
    out.text("\n");
  }
}

/// OFF with colours of vertices and faces where there are labels.
void write_coff(std::ostream& stream, const ColoredMesh& labelled) {
  ByteWriter out(stream);
  const Mesh& mesh = labelled.mesh;
  out.print("{}OFF\n{} {} {}\n", labelled.face_label != nullptr ? "C" : "", mesh.vertex_count(), mesh.face_count(),
            mesh.edge_count());
  print_off_vertices(out, labelled);
  print_off_faces(out, labelled);
  out.finish();
}

void write_off(std::ostream& stream, const ColoredMesh& labelled) {
  ColoredMesh plain = labelled;
  plain.face_label = nullptr;
  write_coff(stream, plain);
}

/// The header of an STL must not begin with "solid": readers would take the file for text.
constexpr std::string_view kHeader = "binary STL, 32-bit floats, face colours in the attribute";
constexpr std::size_t kHeaderBytes = 80;

/// The attribute of a face by its colour: bit 15 is set, then 5 bits each of red, green and blue.
std::uint16_t attribute(const Rgb& color) {
  return std::uint16_t(0x8000 | (color.red >> 3) << 10 | (color.green >> 3) << 5 | color.blue >> 3);
}

/// Binary STL, with the colours of labelled faces in their attributes.
void write_stl(std::ostream& stream, const ColoredMesh& labelled) {
  const Mesh& mesh = labelled.mesh;
  ByteWriter out(stream);
  std::string header(kHeader);
  header.resize(kHeaderBytes, ' ');
  out.text(header);
  out.binary(std::uint32_t(mesh.face_count()));
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    const Vec3& origin = mesh.position(a);
    // Normalized first: the product of two short edges can underflow. A face without area gets the normal 0.
    const Vec3 u = (mesh.position(b) - origin).stableNormalized();
    const Vec3 v = (mesh.position(c) - origin).stableNormalized();
    out.floats(u.cross(v).normalized());
    for (const VertexId corner : {a, b, c}) out.floats(mesh.position(corner));
    out.binary(labelled.face_label != nullptr ? attribute(labelled.color((*labelled.face_label)[f]))
                                              : std::uint16_t{0});
  }
  out.finish();
}

void print_branch_point(ByteWriter& out, const BranchPoint& branch) {
  out.text("{");
  print_point_members(out, branch.point, branch.position);
  out.text(",\"generators\":");
  print_ids(out, branch.generators);
  out.print(",\"distance\":{}}}", json_number(branch.distance));
}

void print_bisector(ByteWriter& out, const Mesh& mesh, const Bisector& bisector) {
  out.print("{{\"left\":{},\"right\":{},\"closed\":{},\"ends\":", bisector.left.value(), bisector.right.value(),
            bisector.closed);
  print_array(out, bisector.ends,
              [&](BranchPointId end) { out.text(end.valid() ? fmt::format("{}", end.value()) : "null"); });
  out.text(",\"points\":");
  print_array(out, bisector.points, [&](const SurfacePoint& point) { print_point(out, mesh, point); });
  out.text("}");
}

/// Points and segments apart, as curves may branch.
void print_curve(ByteWriter& out, const Mesh& mesh, const GeneratorCurve& curve) {
  out.text("{\"points\":");
  print_array(out, curve.points, [&](const SurfacePoint& point) { print_point(out, mesh, point); });
  out.text(",\"segments\":");
  print_array(out, curve.segments, [&](const auto& ends) { out.print("[{},{}]", ends[0], ends[1]); });
  out.text("}");
}

void print_cell(ByteWriter& out, const Cell& cell) {
  out.print("{{\"generator\":{},\"area\":{},\"euler_characteristic\":{},\"neighbours\":", cell.generator.value(),
            json_number(cell.area), cell.euler_characteristic);
  print_ids(out, cell.neighbours);
  out.print(",\"boundary_loops\":{}}}", cell.boundary_loops);
}

}  // namespace

void print_open_diagram(ByteWriter& out, const Mesh& mesh, const Diagram& diagram) {
  out.text("{\"schema\":\"gvd-diagram/1\",\n");
  out.text("\"generators\":");
  print_lines(out, diagram.generators, [&](const SurfacePoint& point) { print_point(out, mesh, point); });
  if (!diagram.weights.empty()) {
    out.text(",\n\"weights\":");
    print_array(out, diagram.weights, [&](double weight) { out.text(json_number(weight)); });
  }
  if (!diagram.curves.empty()) {
    out.text(",\n\"curves\":");
    print_lines(out, diagram.curves, [&](const GeneratorCurve& curve) { print_curve(out, mesh, curve); });
  }
  out.text(",\n\"branch_points\":");
  print_lines(out, diagram.branch_points, [&](const BranchPoint& branch) { print_branch_point(out, branch); });
  out.text(",\n\"bisectors\":");
  print_lines(out, diagram.bisectors, [&](const Bisector& bisector) { print_bisector(out, mesh, bisector); });
  out.text(",\n\"cells\":");
  print_lines(out, diagram.cells, [&](const Cell& cell) { print_cell(out, cell); });
  out.text(",\n\"vertex_labels\":");
  print_ids(out, diagram.vertex_label);
  out.text(",\n\"vertex_distances\":");
  print_array(out, diagram.vertex_distance, [&](double distance) { out.text(json_number(distance)); });
}

void print_mesh_members(ByteWriter& out, const Mesh& mesh) {
  out.text("\"vertices\":");
  print_rows(out, mesh.positions(), [&](const Vec3& p) { out.print("[{},{},{}]", p.x(), p.y(), p.z()); });
  out.text(",\n\"faces\":");
  print_rows(out, mesh.faces(), [&](FaceId f) {
    const auto& [a, b, c] = mesh.vertices(f);
    out.print("[{},{},{}]", a.value(), b.value(), c.value());
  });
}

std::array<double, 3> to_linear(const Rgb& color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return std::round(1e4 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4))) / 1e4;
  };
  return {linear(color.red), linear(color.green), linear(color.blue)};
}

std::string bare_extension(std::string_view extension) {
  return to_lower(extension.substr(extension.starts_with('.') ? 1 : 0));
}

}  // namespace gvd::io

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

void write_json(std::ostream& out, const io::ColoredMesh& mesh) {
  if (mesh.diagram == nullptr) {
    throw Error(ErrorCode::invalid_option, "JSON holds a diagram, and there is none; choose another format");
  }
  write_diagram_json(out, mesh.surface(), *mesh.diagram);
}

/// The distances of the vertices, for formats that hold nothing else.
DistanceTable require_distances(const LabelledMesh& mesh, std::string_view format) {
  if (mesh.vertex_distance != nullptr) return {.rows = {mesh.vertex_distance->raw()}};
  throw Error(ErrorCode::invalid_option,
              fmt::format("{} holds distances of vertices, and there are none; choose another format", format));
}

void write_shape(std::ostream& out, const io::ColoredMesh& mesh) {
  write_distances_gifti(out, require_distances(mesh, ".shape.gii"));
}

void write_curv(std::ostream& out, const io::ColoredMesh& mesh) {
  write_distances_freesurfer(out, require_distances(mesh, ".curv"), mesh.mesh.face_count());
}

void write_bare_obj(std::ostream& out, const io::ColoredMesh& mesh) { io::write_obj(out, mesh, ""); }

/// In the order of OutputFormat.
constexpr std::array kMeshWriters{io::write_ply,
                                  write_bare_obj,
                                  io::write_off,
                                  io::write_coff,
                                  io::write_stl,
                                  io::write_vtp,
                                  io::write_vtu,
                                  io::write_glb,
                                  write_json,
                                  io::write_gifti_surface,
                                  io::write_gifti_labels,
                                  write_shape,
                                  io::write_freesurfer_surface,
                                  io::write_annotation,
                                  write_curv};
static_assert(static_cast<std::size_t>(OutputFormat::freesurfer_values) + 1 == kMeshWriters.size());

}  // namespace

std::string format_extension(const std::filesystem::path& path) {
  const std::string last = io::bare_extension(path.extension().string());
  if (last != "gii") return last;
  const std::string before = io::bare_extension(path.stem().extension().string());
  return before == "label" ? "label.gii" : before == "shape" || before == "func" ? "shape.gii" : "surf.gii";
}

std::optional<OutputFormat> parse_output_format(std::string_view extension) {
  const std::string wanted = io::bare_extension(extension);
  return value_in(kOutputFormatNames, wanted == "gii" ? "surf.gii" : wanted);
}

OutputFormat output_format(const std::filesystem::path& path) {
  if (const auto format = parse_output_format(format_extension(path))) return *format;
  throw Error(ErrorCode::invalid_option, fmt::format("'{}': no output format has this extension; use one of .{}",
                                                     path.string(), fmt::join(names_in(kOutputFormatNames), ", .")));
}

void check_format(const Mesh& mesh, OutputFormat format) {
  constexpr std::array<std::pair<OutputFormat, std::string_view>, 6> kSingle{
      {{OutputFormat::stl, "STL"},
       {OutputFormat::glb, "GLB"},
       {OutputFormat::gifti_surface, "GIFTI"},
       {OutputFormat::gifti_values, "GIFTI"},
       {OutputFormat::freesurfer_surface, "FreeSurfer's surface"},
       {OutputFormat::freesurfer_values, "FreeSurfer's .curv"}}};
  for (const auto& [single, name] : kSingle) {
    if (format != single) continue;
    io::check_single_precision(mesh, name,
                               format == OutputFormat::glb ? io::glb_translation(mesh) : Vec3(Vec3::Zero()));
  }
}

void write_mesh(std::ostream& out, const LabelledMesh& mesh, OutputFormat format) {
  check_lengths(mesh);
  check_format(mesh.mesh, format);
  kMeshWriters[static_cast<std::size_t>(format)](out, io::ColoredMesh(mesh));
}

void write_mesh(const std::filesystem::path& path, const LabelledMesh& mesh, const Progress& progress) {
  const OutputFormat format = output_format(path);
  if (format != OutputFormat::obj || mesh.face_label == nullptr || mesh.names_materials()) {
    return write_file(
        path, [&](std::ostream& out) { write_mesh(out, mesh, format); }, progress);
  }
  const std::filesystem::path materials = std::filesystem::path(path).replace_extension(".mtl");
  const auto write_both = [&](std::ostream& out) {
    check_lengths(mesh);
    io::write_obj(out, mesh, materials.filename().string());
    write_file(
        materials, [&](std::ostream& other) { io::write_materials(other, io::ColoredMesh(mesh)); }, progress);
  };
  write_file(path, write_both, progress);
}

void write_diagram_json(std::ostream& stream, const Mesh& mesh, const Diagram& diagram) {
  io::ByteWriter out(stream);
  io::print_open_diagram(out, mesh, diagram);
  out.text("}\n");
  out.finish();
}

}  // namespace gvd
