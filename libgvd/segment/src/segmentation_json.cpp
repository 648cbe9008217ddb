// Writes a segmentation or a cut mesh as JSON: the document of its diagram (gvd-diagram/1) with one more member, so
// that readers of diagrams can read it, too.
//
// Labels are ids of generators, or -1 if no generator reaches the face. For whole faces only labels are written,
// because their mesh is the input; a cut mesh is written with its vertices and faces.
// Invariant: numbers read back to the same double, and an infinite distance is null.
#include <ostream>

#include "gvd/segment.hpp"
#include "io/writers/byte_writer.hpp"

namespace gvd {
namespace {

/// Prints the member with the numbers, after another member; nothing if there are no numbers.
void print_numbers(io::ByteWriter& out, const std::vector<FaceNumbers>& numbers) {
  if (numbers.empty()) return;
  out.text(",\n\"face_numbers\":{");
  for (const FaceNumbers& each : numbers) {
    out.print("{}\"{}\":", &each == &numbers.front() ? "" : ",\n", each.name);
    io::print_array(out, each.values, [&](std::int32_t number) { out.print("{}", number); });
  }
  out.text("}");
}

}  // namespace

void write_segmentation_json(std::ostream& stream, const Mesh& mesh, const Diagram& diagram,
                             const Segmentation& segmentation, const std::vector<FaceNumbers>& numbers) {
  io::ByteWriter out(stream);
  io::print_open_diagram(out, mesh, diagram);
  out.text(",\"face_labels\":");
  io::print_ids(out, segmentation.face_label);
  print_numbers(out, numbers);
  out.text("}\n");
  out.finish();
}

void write_cut_json(std::ostream& stream, const Mesh& mesh, const Diagram& diagram, const CutMesh& cut,
                    const CutVertices& vertices) {
  io::ByteWriter out(stream);
  io::print_open_diagram(out, mesh, diagram);
  out.text(",\"cut_mesh\":{");
  io::print_mesh_members(out, cut.mesh);
  out.text(",\n\"labels\":");
  io::print_ids(out, cut.label);
  out.text(",\n\"parents\":");
  io::print_ids(out, cut.parent);
  out.text(",\n\"vertex_labels\":");
  io::print_ids(out, vertices.label);
  out.text(",\n\"vertex_distances\":");
  io::print_array(out, vertices.distance, [&](double distance) { out.text(io::json_number(distance)); });
  print_numbers(out, cut.numbers);
  out.text("}}\n");
  out.finish();
}

}  // namespace gvd
