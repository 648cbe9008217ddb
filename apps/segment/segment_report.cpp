// What gvd-segment tells of its regions: members of the report, notes, and the JSON of -o.
//
// Labels are ids of generators, -1 where none reaches. The JSON of -o is that of the diagram with one more member, so
// that a reader of diagrams reads it too: the labels of whole faces, or the mesh that was cut along the bisectors.

#include "segment/segment_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "common/diagram_members.hpp"
#include "gvd/counted.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// A note names this many generators; the report lists all.
constexpr std::size_t kNamed = 8;

template <class Ids>
void write_ids(std::ostream& out, const Ids& ids) {
  write_array(out, ids, "", [](auto id) { return fmt::format("{}", id.value()); });
}

}  // namespace

void report_segmentation(Json& results, const Segmentation& segmentation) {
  Json without_face = Json::array();
  for (const GeneratorId id : segmentation.without_face) without_face.push_back(id.value());
  results["generators_without_face"] = std::move(without_face);
  results["moved_faces"] = segmentation.moved_faces;
  results["given_faces"] = segmentation.given_faces;
  results["smoothed_faces"] = segmentation.smoothed_faces;
}

void report_borders(Json& results, double border_length, double bisector_length) {
  results["border_length"] = border_length;
  results["border_ratio"] = bisector_length > 0 ? Json(border_length / bisector_length) : Json();
}

void report_regions(Json& results, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count) {
  Json regions = Json::array();
  const IdVector<GeneratorId, RegionSize> sizes = measure_regions(mesh, label, count);
  for (const GeneratorId g : sizes.ids()) {
    regions.push_back({{"label", g.value()}, {"faces", sizes[g].faces}, {"area", sizes[g].area}});
  }
  results["faces"] = mesh.face_count();
  results["unreached_faces"] = count_unreached(label);
  results["regions"] = std::move(regions);
}

std::string describe_without_face(const std::vector<GeneratorId>& without_face) {
  std::string names;
  for (std::size_t i = 0; i < std::min(kNamed, without_face.size()); ++i) {
    names += fmt::format("{}{}", i > 0 ? ", " : "", without_face[i].value());
  }
  if (without_face.size() > kNamed) names += ", ...";
  return fmt::format("{} inside faces of other regions: {}",
                     counted(std::ssize(without_face), "generator owns no face, its cell lies",
                             "generators own no face, their cells lie"),
                     names);
}

std::int64_t count_unreached(const IdVector<FaceId, GeneratorId>& label) {
  return std::count_if(label.begin(), label.end(), [](GeneratorId g) { return !g.valid(); });
}

void write_segmentation_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram,
                             const Segmentation& segmentation) {
  out << open_diagram(mesh, diagram) << ",\"face_labels\":";
  write_ids(out, segmentation.face_label);
  out << "}\n";
  finish(out);
}

void write_cut_json(std::ostream& out, const CutOutput& output) {
  out << open_diagram(output.mesh, output.diagram) << ",\"cut_mesh\":{";
  write_mesh_members(out, output.cut.mesh);
  out << ",\n\"labels\":";
  write_ids(out, output.cut.label);
  out << ",\n\"parents\":";
  write_ids(out, output.cut.parent);
  out << ",\n\"vertex_labels\":";
  write_ids(out, output.vertices.label);
  out << ",\n\"vertex_distances\":";
  write_array(out, output.vertices.distance, "", json_number);
  out << "}}\n";
  finish(out);
}

}  // namespace gvd::app
