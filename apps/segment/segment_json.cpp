#include "segment/segment_json.hpp"

#include <string>

#include "common/steps/diagram_members.hpp"

namespace gvd::app {
namespace {

template <class Id>
void write_ids(std::ostream& out, const IdVector<FaceId, Id>& ids) {
  std::string text;
  for (const Id id : ids) {
    text += text.empty() ? "[" : ",";
    text += std::to_string(id.value());
  }
  out << (text.empty() ? "[" : text) << ']';
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
  out << open_diagram(mesh, diagram) << ",\"cut_mesh\":{";
  write_mesh_members(out, cut.mesh);
  out << ",\n\"labels\":";
  write_ids(out, cut.label);
  out << ",\n\"parents\":";
  write_ids(out, cut.parent);
  out << "}}\n";
  finish(out);
}

}  // namespace gvd::app
