#include "io/writers/write_ply.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gvd/io/label_color.hpp"
#include "io/writers/byte_writer.hpp"

// VTK's reader drops every property but coordinates, normals, texture coordinates, colours and a face's `intensity`,
// one byte: the label's low byte goes there. Blender shows the colours of vertices only. meshio reads the properties of
// faces in text only: in binary it takes the lists of all faces to lie behind each other.
namespace gvd::io {
namespace {

/// Whether a float would turn a finite distance into infinity (not reached) or 0 (a generator).
bool leaves_float(double distance) {
  using Float = std::numeric_limits<float>;
  return std::isfinite(distance) && distance != 0 && (distance > Float::max() || distance < Float::min());
}

bool needs_doubles(const LabelledMesh& mesh) {
  return mesh.vertex_distance != nullptr &&
         std::any_of(mesh.vertex_distance->begin(), mesh.vertex_distance->end(), leaves_float);
}

void print_color_properties(ByteWriter& out) {
  out.text("property uchar red\nproperty uchar green\nproperty uchar blue\n");
}

void print_vertex_properties(ByteWriter& out, const LabelledMesh& mesh, bool doubles) {
  out.print("element vertex {}\n", mesh.mesh.vertex_count());
  out.text("property double x\nproperty double y\nproperty double z\n");
  if (mesh.vertex_distance != nullptr) out.print("property {} distance\n", doubles ? "double" : "float");
  if (mesh.vertex_label != nullptr) {
    out.text("property int label\n");
    print_color_properties(out);
  }
}

void print_face_properties(ByteWriter& out, const LabelledMesh& mesh) {
  out.print("element face {}\nproperty list uchar int vertex_indices\n", mesh.mesh.face_count());
  if (mesh.face_label != nullptr) {
    out.text("property int label\n");
    print_color_properties(out);
  }
  if (mesh.face_parent != nullptr) out.text("property int parent\n");
  if (mesh.face_label != nullptr) out.text("property uchar intensity\n");
}

/// Numbers of one element after the other, as bytes or as a line of text.
class Rows {
 public:
  Rows(ByteWriter& out, bool text) : out_(out), text_(text) {}

  template <class T>
  void put(T value) {
    if (!text_) return out_.binary(value);
    out_.print("{}{}", empty_ ? "" : " ", value);
    empty_ = false;
  }

  void put_label(GeneratorId label) {
    const Rgb color = label_color(label);
    put(label.value());
    put(color.red);
    put(color.green);
    put(color.blue);
  }

  void end() {
    if (text_) out_.text("\n");
    empty_ = true;
  }

 private:
  ByteWriter& out_;
  bool text_;
  bool empty_ = true;
};

void write_vertices(Rows& rows, const LabelledMesh& mesh, bool doubles) {
  for (VertexId v(0); v.value() < mesh.mesh.vertex_count(); v = VertexId(v.value() + 1)) {
    const Vec3& p = mesh.mesh.position(v);
    for (int i = 0; i < 3; ++i) rows.put(p[i]);
    if (mesh.vertex_distance != nullptr) {
      const double distance = (*mesh.vertex_distance)[v];
      doubles ? rows.put(distance) : rows.put(static_cast<float>(distance));
    }
    if (mesh.vertex_label != nullptr) rows.put_label((*mesh.vertex_label)[v]);
    rows.end();
  }
}

void write_faces(Rows& rows, const LabelledMesh& mesh) {
  for (FaceId f(0); f.value() < mesh.mesh.face_count(); f = FaceId(f.value() + 1)) {
    rows.put(std::uint8_t{3});
    for (const VertexId v : mesh.mesh.vertices(f)) rows.put(v.value());
    if (mesh.face_label != nullptr) rows.put_label((*mesh.face_label)[f]);
    if (mesh.face_parent != nullptr) rows.put((*mesh.face_parent)[f].value());
    if (mesh.face_label != nullptr) rows.put(static_cast<std::uint8_t>((*mesh.face_label)[f].value()));
    rows.end();
  }
}

}  // namespace

void write_ply(std::ostream& stream, const LabelledMesh& mesh) {
  ByteWriter out(stream);
  const bool doubles = needs_doubles(mesh);
  out.print("ply\nformat {} 1.0\n", mesh.ascii_ply ? "ascii" : "binary_little_endian");
  print_vertex_properties(out, mesh, doubles);
  print_face_properties(out, mesh);
  out.text("end_header\n");
  Rows rows(out, mesh.ascii_ply);
  write_vertices(rows, mesh, doubles);
  write_faces(rows, mesh);
  out.finish();
}

}  // namespace gvd::io
