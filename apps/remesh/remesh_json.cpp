#include "remesh/remesh_json.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string>

#include "gvd/error.hpp"
#include "gvd/io/diagram_json.hpp"

namespace gvd {

void write_remesh_json(std::ostream& out, const Mesh& mesh, const RemeshResult& result) {
  std::ostringstream text;
  write_diagram_json(text, mesh, result.diagram);
  std::string object = std::move(text).str();
  object.erase(object.rfind('}'));
  out << object << ",\"remesh\":{\"vertices\":[";
  const char* separator = "\n";
  for (const Vec3& p : result.mesh.positions()) {
    out << fmt::format("{}[{},{},{}]", separator, p.x(), p.y(), p.z());
    separator = ",\n";
  }
  out << "],\n\"faces\":[";
  separator = "\n";
  for (std::int32_t i = 0; i < result.mesh.face_count(); ++i) {
    const auto& [a, b, c] = result.mesh.vertices(FaceId(i));
    out << fmt::format("{}[{},{},{}]", separator, a.value(), b.value(), c.value());
    separator = ",\n";
  }
  out << "],\n\"face_points\":[";
  separator = "\n";
  for (const SurfacePoint& p : result.face_points) {
    out << fmt::format("{}{{\"face\":{},\"bary\":[{},{},{}]}}", separator, p.face.value(), p.bary[0], p.bary[1],
                       p.bary[2]);
    separator = ",\n";
  }
  out << fmt::format("],\n\"added\":{}}}}}\n", result.added);
  if (!out.flush()) throw Error(ErrorCode::unwritable_output, "could not be written");
}

}  // namespace gvd
