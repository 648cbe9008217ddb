// A diagram as JSON, `gvd-diagram/1`: every element on a line of its own, in the order of the ids.
//
// The text is printed piece by piece instead of built as a document, so memory does not grow with the diagram.
// Invariant: infinity and NaN, which JSON does not have, are null; numbers bring the same double back.
#include "gvd/io/diagram_json.hpp"

#include "io/writers/byte_writer.hpp"
#include "io/writers/json_members.hpp"

namespace gvd {
namespace {

using io::ByteWriter;

void print_branch_point(ByteWriter& out, const BranchPoint& branch) {
  out.text("{");
  io::print_point_members(out, branch.point, branch.position);
  out.text(",\"generators\":");
  io::print_ids(out, branch.generators);
  out.print(",\"distance\":{}}}", io::json_number(branch.distance));
}

void print_bisector(ByteWriter& out, const Mesh& mesh, const Bisector& bisector) {
  out.print("{{\"left\":{},\"right\":{},\"closed\":{},\"ends\":", bisector.left.value(), bisector.right.value(),
            bisector.closed);
  io::print_array(out, bisector.ends,
                  [&](BranchPointId end) { out.text(end.valid() ? fmt::format("{}", end.value()) : "null"); });
  out.text(",\"points\":");
  io::print_array(out, bisector.points, [&](const SurfacePoint& point) { io::print_point(out, mesh, point); });
  out.text("}");
}

void print_cell(ByteWriter& out, const Cell& cell) {
  out.print("{{\"generator\":{},\"area\":{},\"euler_characteristic\":{},\"neighbours\":", cell.generator.value(),
            io::json_number(cell.area), cell.euler_characteristic);
  io::print_ids(out, cell.neighbours);
  out.print(",\"boundary_loops\":{}}}", cell.boundary_loops);
}

}  // namespace

void io::print_open_diagram(ByteWriter& out, const Mesh& mesh, const Diagram& diagram) {
  out.text("{\"schema\":\"gvd-diagram/1\",\n");
  out.text("\"generators\":");
  io::print_lines(out, diagram.generators, [&](const SurfacePoint& point) { io::print_point(out, mesh, point); });
  out.text(",\n\"branch_points\":");
  io::print_lines(out, diagram.branch_points, [&](const BranchPoint& branch) { print_branch_point(out, branch); });
  out.text(",\n\"bisectors\":");
  io::print_lines(out, diagram.bisectors, [&](const Bisector& bisector) { print_bisector(out, mesh, bisector); });
  out.text(",\n\"cells\":");
  io::print_lines(out, diagram.cells, [&](const Cell& cell) { print_cell(out, cell); });
  out.text(",\n\"vertex_labels\":");
  io::print_ids(out, diagram.vertex_label);
  out.text(",\n\"vertex_distances\":");
  io::print_array(out, diagram.vertex_distance, [&](double distance) { out.text(io::json_number(distance)); });
}

void io::print_mesh_members(ByteWriter& out, const Mesh& mesh) {
  out.text("\"vertices\":");
  print_rows(out, mesh.positions(), [&](const Vec3& p) { out.print("[{},{},{}]", p.x(), p.y(), p.z()); });
  out.text(",\n\"faces\":");
  print_rows(out, mesh.faces(), [&](FaceId f) {
    const auto& [a, b, c] = mesh.vertices(f);
    out.print("[{},{},{}]", a.value(), b.value(), c.value());
  });
}

void write_diagram_json(std::ostream& stream, const Mesh& mesh, const Diagram& diagram) {
  ByteWriter out(stream);
  io::print_open_diagram(out, mesh, diagram);
  out.text("}\n");
  out.finish();
}

}  // namespace gvd
