// A remesh and its map as JSON.
//
// The remesh is one more member of the document of its diagram (gvd-diagram/1), so that a reader of diagrams reads it
// too. The map (gvd-remesh-map/1) numbers the vertices of the input as the input's file does, and not as the checked
// mesh. Both print element by element: memory does not grow with the result. docs/schema/README.md describes them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "gvd/remesh.hpp"
#include "gvd/remesh_map.hpp"
#include "io/writers/byte_writer.hpp"

namespace gvd {
namespace {

void print_place(io::ByteWriter& out, const SurfacePoint& point) {
  out.text("{");
  io::print_location(out, point);
  out.text("}");
}

/// The members of a map that are not lists.
void print_map_figures(io::ByteWriter& out, const RemeshMap& map) {
  const nlohmann::json obstacle = map.one_to_one ? nlohmann::json() : nlohmann::json(map.obstacle);
  out.print("\"schema\":\"gvd-remesh-map/1\",\"one_to_one\":{},\"obstacle\":{}", map.one_to_one, obstacle.dump());
  out.print(",\"faces\":{{\"kept\":{},\"reversed\":{},\"collapsed\":{}}}", map.kept_faces, map.reversed_faces,
            map.collapsed_faces);
  out.print(",\"largest_move\":{},\"mean_move\":{}", map.largest_move, map.mean_move);
}

}  // namespace

void write_remesh_json(std::ostream& stream, const Mesh& mesh, const RemeshResult& result) {
  io::ByteWriter out(stream);
  io::print_open_diagram(out, mesh, result.diagram);
  out.text(",\"remesh\":{");
  io::print_mesh_members(out, result.mesh);
  out.text(",\n\"face_points\":");
  io::print_rows(out, result.face_points, [&](const SurfacePoint& p) { print_place(out, p); });
  out.print(",\n\"added\":{}}}}}\n", result.added);
  out.finish();
}

void write_map_json(std::ostream& stream, const CheckedMesh& input, const RemeshMap& map) {
  io::ByteWriter out(stream);
  out.text("{");
  print_map_figures(out, map);
  out.text(",\n\"output_vertices\":");
  io::print_rows(out, map.origins, [&](const SurfacePoint& p) {
    const auto& [a, b, c] = input.mesh.vertices(p.face);
    out.text("{");
    io::print_location(out, p);
    out.print(",\"vertices\":[{},{},{}]}}", input.input_vertex[a], input.input_vertex[b], input.input_vertex[c]);
  });
  out.text(",\n\"input_vertices\":");
  io::print_rows(out, input.mesh_vertex, [&](VertexId v) {
    if (!v.valid()) return out.text("null");
    print_place(out, map.points[v]);
  });
  out.text("}\n");
  out.finish();
}

}  // namespace gvd
