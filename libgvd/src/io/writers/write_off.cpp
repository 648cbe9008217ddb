// Writes OFF and COFF.
//
// OFF is written without colours, because meshio reads exactly three numbers for a vertex and four for a face. COFF has
// four numbers from 0 to 1 after each vertex, as Geomview specifies, and three from 0 to 255 after each face. OFF with
// colours of faces only is also valid, but OpenMesh reads these colours as the next face.
// Source: the Geomview manual, section OFF.
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

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

}  // namespace

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

}  // namespace gvd::io
