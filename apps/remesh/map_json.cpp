#include "remesh/map_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "common/steps/diagram_members.hpp"

namespace gvd::app {
namespace {

/// Null where the map is one-to-one.
nlohmann::ordered_json obstacle(const RemeshMap& map) {
  return map.one_to_one ? nlohmann::ordered_json() : nlohmann::ordered_json(map.obstacle);
}

void write_output_vertices(std::ostream& out, const CheckedMesh& input, const RemeshMap& map) {
  out << ",\n\"output_vertices\":[";
  const char* separator = "\n";
  for (const SurfacePoint& p : map.origins) {
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

void write_map_json(std::ostream& out, const CheckedMesh& input, const RemeshMap& map) {
  out << fmt::format("{{\"schema\":\"gvd-remesh-map/1\",\"one_to_one\":{},\"obstacle\":{}", map.one_to_one,
                     obstacle(map).dump());
  out << fmt::format(",\"faces\":{{\"kept\":{},\"reversed\":{},\"collapsed\":{}}}", map.kept_faces, map.reversed_faces,
                     map.collapsed_faces);
  out << fmt::format(",\"largest_move\":{},\"mean_move\":{}", map.largest_move, map.mean_move);
  write_output_vertices(out, input, map);
  write_input_vertices(out, input, map);
  out << "}\n";
  finish(out);
}

void report_map(Run& run, const RemeshMap& map) {
  run.report().results()["map"] = {{"one_to_one", map.one_to_one},
                                   {"obstacle", obstacle(map)},
                                   {"kept_faces", map.kept_faces},
                                   {"reversed_faces", map.reversed_faces},
                                   {"collapsed_faces", map.collapsed_faces},
                                   {"largest_move", map.largest_move},
                                   {"mean_move", map.mean_move}};
  const std::string move = fmt::format("vertices are {:.3g} from their points on average", map.mean_move);
  if (map.one_to_one) {
    run.console().note(fmt::format("map: one-to-one; {}", move));
  } else {
    run.console().note(
        fmt::format("map: nearest points, several vertices may have the same one: {}; {}", map.obstacle, move));
  }
}

}  // namespace gvd::app
