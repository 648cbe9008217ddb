#include "common/diagram_members.hpp"

#include <fmt/format.h>

#include <sstream>

#include "gvd/error.hpp"
#include "gvd/io/diagram_json.hpp"

namespace gvd::app {

std::string open_diagram(const Mesh& mesh, const Diagram& diagram) {
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // a lack of memory must not pass for a failed write
  write_diagram_json(text, mesh, diagram);
  std::string object = std::move(text).str();
  object.erase(object.rfind('}'));
  return object;
}

std::string open_point(const SurfacePoint& point) {
  return fmt::format("{{\"face\":{},\"bary\":[{},{},{}]", point.face.value(), point.bary[0], point.bary[1],
                     point.bary[2]);
}

void write_mesh_members(std::ostream& out, const Mesh& mesh) {
  out << "\"vertices\":[";
  const char* separator = "\n";
  for (const Vec3& p : mesh.positions()) {
    out << fmt::format("{}[{},{},{}]", separator, p.x(), p.y(), p.z());
    separator = ",\n";
  }
  out << "],\n\"faces\":[";
  separator = "\n";
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const auto& [a, b, c] = mesh.vertices(FaceId(i));
    out << fmt::format("{}[{},{},{}]", separator, a.value(), b.value(), c.value());
    separator = ",\n";
  }
  out << "]";
}

void finish(std::ostream& out) {
  if (!out.flush()) throw Error(ErrorCode::unwritable_output, "the output stream could not be written");
}

}  // namespace gvd::app
