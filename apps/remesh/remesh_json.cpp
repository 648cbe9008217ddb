#include "remesh/remesh_json.hpp"

#include <fmt/format.h>

#include "common/steps/diagram_members.hpp"

namespace gvd::app {

void write_remesh_json(std::ostream& out, const Mesh& mesh, const RemeshResult& result) {
  out << open_diagram(mesh, result.diagram) << ",\"remesh\":{";
  write_mesh_members(out, result.mesh);
  out << ",\n\"face_points\":[";
  const char* separator = "\n";
  for (const SurfacePoint& p : result.face_points) {
    out << separator << open_point(p) << "}";
    separator = ",\n";
  }
  out << fmt::format("],\n\"added\":{}}}}}\n", result.added);
  finish(out);
}

}  // namespace gvd::app
