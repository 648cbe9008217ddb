// Wavefront OBJ, with its materials in a file of their own.
//
// A region is a group with a material. Bisectors are lines, whose vertices follow those of the mesh, so the numbers of
// the mesh's vertices are those of the input. OBJ counts from 1, and shares texture coordinates between faces by
// number.
// Source: Wavefront's Advanced Visualizer manual, appendix B1, for the statements v, vt, f, l, g, mtllib and usemtl.
// Invariant: the vertices of the mesh keep their numbers with and without bisectors, groups and texture.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "gvd/io/label_color.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

void print_vertex(ByteWriter& out, const Vec3& p) { out.print("v {} {} {}\n", p.x(), p.y(), p.z()); }

/// Writes the coordinates of corners, equal ones of a vertex once. Gives their number for each corner, from 1; none
/// without a texture.
std::vector<std::size_t> print_texture(ByteWriter& out, const LabelledMesh& mesh) {
  std::vector<std::size_t> numbers;
  if (mesh.corner_texture == nullptr) return numbers;
  using Numbered = std::pair<std::array<double, 2>, std::size_t>;
  IdVector<VertexId, std::vector<Numbered>> known(mesh.mesh.vertex_count());
  std::size_t count = 0;
  for (const HalfedgeId h : mesh.mesh.halfedges()) {
    const std::array<double, 2>& uv = (*mesh.corner_texture)[h.index()];
    std::vector<Numbered>& at = known[mesh.mesh.from(h)];
    auto found = std::find_if(at.begin(), at.end(), [&](const Numbered& n) { return n.first == uv; });
    if (found == at.end() && std::isfinite(uv[0]) && std::isfinite(uv[1])) {
      out.print("vt {} {}\n", uv[0], uv[1]);
      found = at.insert(at.end(), {uv, ++count});
    }
    numbers.push_back(found == at.end() ? 0 : found->second);
  }
  return numbers;
}

/// A face without texture coordinates, or with those of its corners. `texture`: what print_texture gave.
void print_face(ByteWriter& out, const Mesh& mesh, const std::vector<std::size_t>& texture, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  const std::size_t* t = texture.empty() ? nullptr : texture.data() + 3 * f.index();
  if (t == nullptr || t[0] == 0 || t[1] == 0 || t[2] == 0) {
    out.print("f {} {} {}\n", a.value() + 1, b.value() + 1, c.value() + 1);
  } else {
    out.print("f {}/{} {}/{} {}/{}\n", a.value() + 1, t[0], b.value() + 1, t[1], c.value() + 1, t[2]);
  }
}

void print_regions(ByteWriter& out, const LabelledMesh& mesh, const std::vector<std::size_t>& texture,
                   bool with_materials) {
  for (const Region& region : collect_regions(mesh)) {
    const std::string name = region_name(region.label);
    out.print("g {}\n", name);
    if (with_materials) out.print("usemtl {}\n", name);
    for (const FaceId f : region.faces) print_face(out, mesh.mesh, texture, f);
  }
}

/// The line through the vertices from number `first` on, one `l` for each segment: Blender keeps one edge of a longer
/// `l`.
/// Returns the number after the last vertex.
std::size_t print_line(ByteWriter& out, const BisectorLine& line, std::size_t first) {
  out.print("# left {} right {}\n", line.left.value(), line.right.value());
  for (const Vec3& p : line.points) print_vertex(out, p);
  const std::size_t last = first + line.points.size() - 1;
  for (std::size_t i = first; i < last; ++i) out.print("l {} {}\n", i, i + 1);
  return last + 1;
}

/// The vertices of the lines follow those of the mesh, whose numbers do not change.
void print_lines(ByteWriter& out, const LabelledMesh& mesh) {
  const std::vector<BisectorLine> lines = collect_bisector_lines(mesh);
  if (lines.empty()) return;
  out.text("g bisectors\n");
  std::size_t index = mesh.mesh.positions().size() + 1;
  for (const BisectorLine& line : lines) index = print_line(out, line, index);
}

}  // namespace

void write_obj(std::ostream& stream, const LabelledMesh& mesh, const std::string& material_library) {
  ByteWriter out(stream);
  if (!material_library.empty()) out.print("mtllib {}\n", material_library);
  for (const Vec3& p : mesh.mesh.positions()) print_vertex(out, p);
  const std::vector<std::size_t> texture = print_texture(out, mesh);
  if (mesh.face_label != nullptr) {
    print_regions(out, mesh, texture, !material_library.empty());
  } else {
    for (const FaceId f : mesh.mesh.faces()) print_face(out, mesh.mesh, texture, f);
  }
  print_lines(out, mesh);
  out.finish();
}

void write_materials(std::ostream& stream, const LabelledMesh& mesh) {
  ByteWriter out(stream);
  for (const Region& region : collect_regions(mesh)) {
    const Rgb color = label_color(region.label);
    out.print("newmtl {}\nKd {:.4f} {:.4f} {:.4f}\n", region_name(region.label), color.red / 255.0, color.green / 255.0,
              color.blue / 255.0);
  }
  out.finish();
}

}  // namespace gvd::io
