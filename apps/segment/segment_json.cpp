#include "segment/segment_json.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string>

#include "gvd/error.hpp"
#include "gvd/io/diagram_json.hpp"

namespace gvd {
namespace {

/// The diagram's text, open for one more member.
std::string open_diagram(const Mesh& mesh, const Diagram& diagram) {
  std::ostringstream text;
  write_diagram_json(text, mesh, diagram);
  std::string object = std::move(text).str();
  object.erase(object.rfind('}'));
  return object;
}

template <class Id>
void write_ids(std::ostream& out, const IdVector<FaceId, Id>& ids) {
  out << '[';
  const char* separator = "";
  for (const Id id : ids) {
    out << fmt::format("{}{}", separator, id.value());
    separator = ",";
  }
  out << ']';
}

void finish(std::ostream& out) {
  if (!out.flush()) throw Error(ErrorCode::unwritable_output, "could not be written");
}

}  // namespace

void write_segmentation_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram,
                             const Segmentation& segmentation) {
  out << open_diagram(mesh, diagram) << ",\"face_labels\":";
  write_ids(out, segmentation.face_label);
  out << "}\n";
  finish(out);
}

void write_cut_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram, const CutMesh& cut) {
  out << open_diagram(mesh, diagram) << ",\"cut_mesh\":{\"vertices\":[";
  const char* separator = "\n";
  for (const Vec3& p : cut.mesh.positions()) {
    out << fmt::format("{}[{},{},{}]", separator, p.x(), p.y(), p.z());
    separator = ",\n";
  }
  out << "],\n\"faces\":[";
  separator = "\n";
  for (std::int32_t i = 0; i < cut.mesh.face_count(); ++i) {
    const auto& [a, b, c] = cut.mesh.vertices(FaceId(i));
    out << fmt::format("{}[{},{},{}]", separator, a.value(), b.value(), c.value());
    separator = ",\n";
  }
  out << "],\n\"labels\":";
  write_ids(out, cut.label);
  out << ",\n\"parents\":";
  write_ids(out, cut.parent);
  out << "}}\n";
  finish(out);
}

}  // namespace gvd
