#include "remesh/map_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "common/steps/diagram_members.hpp"
#include "gvd/counted.hpp"

namespace gvd::app {
namespace {

/// Without its closing bracket.
std::string open_point(const SurfacePoint& p) {
  return fmt::format("{{\"face\":{},\"bary\":[{},{},{}]", p.face.value(), p.bary[0], p.bary[1], p.bary[2]);
}

void write_output_vertices(std::ostream& out, const CheckedMesh& input, const RemeshResult& result) {
  out << ",\n\"output_vertices\":[";
  const char* separator = "\n";
  for (const SurfacePoint& p : result.generators) {
    const auto& [a, b, c] = input.mesh.vertices(p.face);
    out << separator << open_point(p)
        << fmt::format(",\"vertices\":[{},{},{}]}}", input.input_vertex[a], input.input_vertex[b],
                       input.input_vertex[c]);
    separator = ",\n";
  }
  out << "]";
}

void write_input_vertices(std::ostream& out, const CheckedMesh& input, const RemeshMap& map) {
  out << ",\n\"input_vertices\":[";
  const char* separator = "\n";
  for (const VertexId v : input.mesh_vertex) {
    out << separator;
    v.valid() ? out << open_point(map.points[v]) << "}" : out << "null";
    separator = ",\n";
  }
  out << "]";
}

}  // namespace

void write_map_json(std::ostream& out, const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map) {
  out << fmt::format("{{\"schema\":\"gvd-remesh-map/1\",\"faces\":{{\"kept\":{},\"reversed\":{},\"collapsed\":{}}}",
                     map.kept_faces, map.reversed_faces, map.collapsed_faces);
  out << fmt::format(",\"largest_move\":{}", map.largest_move);
  write_output_vertices(out, input, result);
  write_input_vertices(out, input, map);
  out << "}\n";
  finish(out);
}

void report_map(Run& run, const RemeshMap& map) {
  run.report().results()["map"] = {{"kept_faces", map.kept_faces},
                                   {"reversed_faces", map.reversed_faces},
                                   {"collapsed_faces", map.collapsed_faces},
                                   {"largest_move", map.largest_move}};
  const std::int64_t faces = map.kept_faces + map.reversed_faces + map.collapsed_faces;
  run.console().note(
      fmt::format("map: {} of the input's {} keep their orientation", map.kept_faces, counted(faces, "face", "faces")));
}

}  // namespace gvd::app
