// Writes Wavefront's OBJ, and the materials of its regions.
//
// A region is a group with a material, unless the faces have materials of their own, whose names are then kept.
// Bisectors are lines. Their vertices follow the mesh's vertices, which therefore keep the numbers of the input. OBJ
// counts from 1, and faces share texture coordinates by number.
// Source: Wavefront's Advanced Visualizer manual, appendix B1, for the statements v, vt, f, l, g, mtllib and usemtl.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

void print_vertex(ByteWriter& out, const Vec3& p) { out.print("v {} {} {}\n", p.x(), p.y(), p.z()); }

/// New texture coordinates of a vertex are compared only with this many of its last ones, because the tip of a cone may
/// have very many.
constexpr std::ptrdiff_t kComparedTexture = 64;

/// Writes the texture coordinates of corners, equal ones at a vertex only once. Returns the number of each corner's
/// coordinates, from 1; nothing if the mesh has no texture.
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

/// Prints the faces, grouped by region if there are regions, with the numbers of their texture coordinates and the
/// names of their materials. `region_materials`: whether each region has a material of its own.
void print_faces(ByteWriter& out, const LabelledMesh& mesh, bool region_materials) {
  const std::vector<std::size_t> texture = print_texture(out, mesh);
  std::int32_t used = -1;  // the material of the last statement, which holds for all faces up to the next one
  const auto print = [&](FaceId f) {
    if (mesh.names_materials()) {
      const std::int32_t material = mesh.appearance->material[f.index()];
      const auto name = [&] {
        return material < 0 ? kNoMaterial : std::string_view(mesh.appearance->materials[material]);
      };
      if (material != used) out.print("usemtl {}\n", name());
      used = material;
    }
    const auto& [a, b, c] = mesh.mesh.vertices(f);
    const std::size_t* t = texture.empty() ? nullptr : texture.data() + 3 * f.index();
    if (t == nullptr || t[0] == 0 || t[1] == 0 || t[2] == 0) {
      out.print("f {} {} {}\n", a.value() + 1, b.value() + 1, c.value() + 1);
    } else {
      out.print("f {}/{} {}/{} {}/{}\n", a.value() + 1, t[0], b.value() + 1, t[1], c.value() + 1, t[2]);
    }
  };
  if (mesh.face_label == nullptr) {
    for (const FaceId f : mesh.mesh.faces()) print(f);
    return;
  }
  for (const Region& region : collect_regions(mesh)) {
    const std::string name = region_name(region.label);
    out.print("g {}\n", name);
    if (region_materials) out.print("usemtl {}\n", name);
    for (const FaceId f : region.faces) print(f);
  }
}

/// Prints the line through the vertices from number `first` on, with one `l` for each segment, because Blender keeps
/// only one edge of a longer `l`.
/// Returns the number after the last vertex.
std::size_t print_line(ByteWriter& out, const OutputLine& line, std::size_t first) {
  if (line.left.valid()) out.print("# left {} right {}\n", line.left.value(), line.right.value());
  for (const Vec3& p : line.points) print_vertex(out, p);
  const std::size_t last = first + line.points.size() - 1;
  for (std::size_t i = first; i < last; ++i) out.print("l {} {}\n", i, i + 1);
  return last + 1;
}

/// Prints the lines and their vertices, which follow the mesh's vertices. Bisectors and curves are objects of their
/// own; otherwise Blender would add them to the mesh as loose edges.
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

}  // namespace

void write_obj_with_library(std::ostream& stream, const LabelledMesh& mesh, const std::string& material_library) {
  ByteWriter out(stream);
  if (!material_library.empty()) out.print("mtllib {}\n", material_library);
  if (mesh.names_materials()) {
    for (const std::string& file : mesh.appearance->material_files) out.print("mtllib {}\n", file);
  }
  for (const Vec3& p : mesh.mesh.positions()) print_vertex(out, p);
  print_faces(out, mesh, !material_library.empty());
  print_lines(out, mesh);
  out.finish();
}

void write_obj(std::ostream& stream, const ColoredMesh& mesh) { write_obj_with_library(stream, mesh, ""); }

void write_materials(std::ostream& stream, const ColoredMesh& mesh) {
  ByteWriter out(stream);
  for (const Region& region : collect_regions(mesh)) {
    const std::array<double, 3> color = to_linear(mesh.color(region.label));
    out.print("newmtl {}\nKd {:.4f} {:.4f} {:.4f}\n", region_name(region.label), color[0], color[1], color[2]);
  }
  out.finish();
}

}  // namespace gvd::io
