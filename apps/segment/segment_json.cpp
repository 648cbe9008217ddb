#include "segment/segment_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "common/steps/diagram_members.hpp"

namespace gvd::app {
namespace {

/// Writes an array on one line; `format_item` gives the text of each item.
template <class Items, class FormatItem>
void write_array(std::ostream& out, const Items& items, FormatItem format_item) {
  const char* separator = "[";
  for (const auto& item : items) {
    out << separator << format_item(item);
    separator = ",";
  }
  out << (items.empty() ? "[]" : "]");
}

template <class Ids>
void write_ids(std::ostream& out, const Ids& ids) {
  write_array(out, ids, [](auto id) { return fmt::format("{}", id.value()); });
}

/// JSON has no infinity.
std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

}  // namespace

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
  write_array(out, output.vertices.distance, json_number);
  out << "}}\n";
  finish(out);
}

}  // namespace gvd::app
