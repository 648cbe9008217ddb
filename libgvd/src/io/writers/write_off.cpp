// OFF, the text format of Geomview.
//
// A coloured OFF has the header COFF. Four numbers from 0 to 1 follow each vertex, as Geomview specifies, and three
// from 0 to 255 each face. Plain OFF with colours of faces only is valid too, but OpenMesh reads the colours as the
// next face.
// Source: the Geomview manual, section OFF.
// Invariant: a file has colours of all vertices and faces, or of none.
#include "gvd/io/label_color.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

GeneratorId vertex_label(const LabelledMesh& labelled, VertexId v) {
  if (labelled.vertex_label != nullptr) return (*labelled.vertex_label)[v];
  return (*labelled.face_label)[Mesh::face(labelled.mesh.halfedge(v))];
}

void print_vertices(ByteWriter& out, const LabelledMesh& labelled) {
  for (const VertexId v : labelled.mesh.vertices()) {
    const Vec3& p = labelled.mesh.position(v);
    out.print("{} {} {}", p.x(), p.y(), p.z());
    if (labelled.face_label != nullptr) {
      const Rgb color = label_color(vertex_label(labelled, v));
      out.print(" {:.4f} {:.4f} {:.4f} 1.0", color.red / 255.0, color.green / 255.0, color.blue / 255.0);
    }
    out.text("\n");
  }
}

void print_faces(ByteWriter& out, const LabelledMesh& labelled) {
  for (const FaceId f : labelled.mesh.faces()) {
    const auto& [a, b, c] = labelled.mesh.vertices(f);
    out.print("3 {} {} {}", a.value(), b.value(), c.value());
    if (labelled.face_label != nullptr) {
      const Rgb color = label_color((*labelled.face_label)[f]);
      out.print(" {} {} {}", color.red, color.green, color.blue);
    }
    out.text("\n");
  }
}

}  // namespace

void write_off(std::ostream& stream, const LabelledMesh& labelled) {
  ByteWriter out(stream);
  const Mesh& mesh = labelled.mesh;
  out.print("{}OFF\n{} {} {}\n", labelled.face_label != nullptr ? "C" : "", mesh.vertex_count(), mesh.face_count(),
            mesh.edge_count());
  print_vertices(out, labelled);
  print_faces(out, labelled);
  out.finish();
}

}  // namespace gvd::io
