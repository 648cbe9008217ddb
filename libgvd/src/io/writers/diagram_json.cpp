// Writes a diagram as JSON, `gvd-diagram/1`: every element on a line of its own, in the order of the ids. The text is
// printed piece by piece instead of being built as a document, so memory does not grow with the diagram. Infinity and
// NaN, which JSON does not have, are null; all other numbers read back to the same double.
#include "gvd/io/diagram_json.hpp"

#include <fmt/format.h>

#include "gvd/error.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

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

/// Prints points and segments as two arrays, because curves may branch.
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

void write_diagram(std::ostream& out, const ColoredMesh& mesh) {
  if (mesh.diagram == nullptr) {
    throw Error(ErrorCode::invalid_option, "JSON holds a diagram, and there is none; choose another format");
  }
  write_diagram_json(out, mesh.surface(), *mesh.diagram);
}

}  // namespace gvd::io

namespace gvd {

void write_diagram_json(std::ostream& stream, const Mesh& mesh, const Diagram& diagram) {
  io::ByteWriter out(stream);
  io::print_open_diagram(out, mesh, diagram);
  out.text("}\n");
  out.finish();
}

}  // namespace gvd
