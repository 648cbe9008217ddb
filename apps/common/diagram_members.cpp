// Parts of the JSON that commands write: members beside a diagram's, points and arrays.
//
// A command's JSON is a diagram (gvd-diagram/1) with one more member. write_diagram_json ends with a brace, which is
// taken off again here. Numbers have the digits that bring the same double back.

#include "common/diagram_members.hpp"

#include <fmt/format.h>

#include <cmath>
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

std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

void write_mesh_members(std::ostream& out, const Mesh& mesh) {
  out << "\"vertices\":";
  write_array(out, mesh.positions(), "\n",
              [](const Vec3& p) { return fmt::format("[{},{},{}]", p.x(), p.y(), p.z()); });
  out << ",\n\"faces\":";
  write_array(out, mesh.faces(), "\n", [&](FaceId f) {
    const auto& [a, b, c] = mesh.vertices(f);
    return fmt::format("[{},{},{}]", a.value(), b.value(), c.value());
  });
}

void finish(std::ostream& out) {
  if (!out.flush()) throw Error(ErrorCode::unwritable_output, "the output stream could not be written");
}

}  // namespace gvd::app
