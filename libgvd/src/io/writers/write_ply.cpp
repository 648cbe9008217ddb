#include "io/writers/write_ply.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gvd/io/label_color.hpp"
#include "io/writers/byte_writer.hpp"

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

void print_header(ByteWriter& out, const LabelledMesh& mesh, bool doubles) {
  out.text("ply\nformat binary_little_endian 1.0\n");
  out.print("element vertex {}\n", mesh.mesh.vertex_count());
  out.text("property double x\nproperty double y\nproperty double z\n");
  if (mesh.vertex_distance != nullptr) out.print("property {} distance\n", doubles ? "double" : "float");
  if (mesh.vertex_label != nullptr) out.text("property int label\n");
  out.print("element face {}\nproperty list uchar int vertex_indices\n", mesh.mesh.face_count());
  if (mesh.face_label != nullptr) {
    out.text("property int label\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n");
  }
  if (mesh.face_parent != nullptr) out.text("property int parent\n");
  out.text("end_header\n");
}

void write_distance(ByteWriter& out, double distance, bool doubles) {
  doubles ? out.binary(distance) : out.binary(static_cast<float>(distance));
}

void write_vertices(ByteWriter& out, const LabelledMesh& mesh, bool doubles) {
  for (VertexId v(0); v.value() < mesh.mesh.vertex_count(); v = VertexId(v.value() + 1)) {
    const Vec3& p = mesh.mesh.position(v);
    out.binary(p.x());
    out.binary(p.y());
    out.binary(p.z());
    if (mesh.vertex_distance != nullptr) write_distance(out, (*mesh.vertex_distance)[v], doubles);
    if (mesh.vertex_label != nullptr) out.binary((*mesh.vertex_label)[v].value());
  }
}

void write_faces(ByteWriter& out, const LabelledMesh& mesh) {
  for (FaceId f(0); f.value() < mesh.mesh.face_count(); f = FaceId(f.value() + 1)) {
    out.binary(std::uint8_t{3});
    for (const VertexId v : mesh.mesh.vertices(f)) out.binary(v.value());
    if (mesh.face_label != nullptr) {
      const GeneratorId label = (*mesh.face_label)[f];
      const Rgb color = label_color(label);
      out.binary(label.value());
      out.binary(color.red);
      out.binary(color.green);
      out.binary(color.blue);
    }
    if (mesh.face_parent != nullptr) out.binary((*mesh.face_parent)[f].value());
  }
}

}  // namespace

void write_ply(std::ostream& stream, const LabelledMesh& mesh) {
  ByteWriter out(stream);
  const bool doubles = needs_doubles(mesh);
  print_header(out, mesh, doubles);
  write_vertices(out, mesh, doubles);
  write_faces(out, mesh);
  out.finish();
}

}  // namespace gvd::io
