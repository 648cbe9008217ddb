// gvd-segment: labels the faces of a mesh, or cuts them along the bisectors.
//
// Whole faces get the label of the generator whose cell has them, so that borders run along edges; --cut splits the
// faces along the bisectors, and each new face knows its parent (gvd/segment.hpp). The report has the figures of the
// regions, and notes tell what users should not miss: generators that own no face, and faces that none reaches.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "common/options/typed_options.hpp"
#include "common/run_parts.hpp"
#include "gvd/region_statistics.hpp"
#include "gvd/segment.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExamples =
    "  gvd-segment bunny.obj -n 30 -o regions.ply\n"
    "  gvd-segment bunny.obj --generators samples.json -o regions.obj --view a.html\n"
    "  gvd-segment scan.stl --radius 2.5 --cut -o pieces.ply --report report.json\n"
    "  gvd-segment - --input-format ply --vertices 3,17,99 -o - < a.ply > b.ply\n"
    "  gvd-segment scans/*.stl -n 30 --output-dir regions --output-format ply,json\n";

const Choices<FaceLabels> kLabels{{"smooth", FaceLabels::smooth}, {"nearest", FaceLabels::nearest}};

/// A note names this many generators.
constexpr std::size_t kNamed = 8;

/// The options of gvd-segment alone.
struct OwnOptions {
  bool cut = false;
  std::optional<FaceLabels> labels;  ///< of whole faces
};

void report_options(Run& run, const OwnOptions& own, const SegmentOptions& options) {
  Json& reported = run.report().options();
  const std::string& stats = run.options().output.own.at("--stats");
  reported["cut"] = own.cut;
  reported["stats"] = stats.empty() ? nullptr : Json(stats);
  reported["labels"] = own.cut ? nullptr : Json(name_in(kLabels, options.labels));
}

/// Faces that no generator reaches.
std::int64_t count_unreached(const IdVector<FaceId, GeneratorId>& label) {
  return std::count_if(label.begin(), label.end(), [](GeneratorId g) { return !g.valid(); });
}

/// The note on generators that own no face. It names a few of them; the report lists all.
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

void report_segmentation(Json& results, const Segmentation& segmentation) {
  Json without_face = Json::array();
  for (const GeneratorId id : segmentation.without_face) without_face.push_back(id.value());
  results["generators_without_face"] = std::move(without_face);
  results["moved_faces"] = segmentation.moved_faces;
  results["given_faces"] = segmentation.given_faces;
  results["smoothed_faces"] = segmentation.smoothed_faces;
}

/// Lengths are in mesh units.
void report_borders(Json& results, double border_length, double bisector_length) {
  results["border_length"] = border_length;
  results["border_ratio"] = bisector_length > 0 ? Json(border_length / bisector_length) : Json();
}

/// Reports the size of each of `count` regions.
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

void note_regions(Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count) {
  if (const std::int64_t unreached = count_unreached(label); unreached > 0) {
    run.console().note(fmt::format("{} reached by no generator: label -1", counted(unreached, "face is", "faces are")));
  }
  report_regions(run.report().results(), mesh, label, count);
}

void write_files(Run& run, const LabelledMesh& output, const OutputWriter& write_json) {
  write_output_files(run, output, {{"json", write_json}});
  write_view_file(run, "gvd-segment", [&] { return std::vector{make_view_scene("Regions", output)}; });
}

void note_segmentation(Run& run, const Mesh& mesh, const Diagram& diagram, const Segmentation& segmentation) {
  const double borders = compute_border_length(mesh, segmentation.face_label);
  if (!segmentation.without_face.empty()) run.console().note(describe_without_face(segmentation.without_face));
  report_segmentation(run.report().results(), segmentation);
  if (diagram.length > 0) {
    run.console().detail(
        fmt::format("borders of length {:.6g}, {:.3f} times that of the bisectors", borders, borders / diagram.length));
  }
  report_borders(run.report().results(), borders, diagram.length);
  note_regions(run, mesh, segmentation.face_label, diagram.generators.size());
}

void write_whole_faces(Run& run, const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options) {
  const Segmentation segmentation = run.timed("segment", [&] { return segment_faces(mesh, diagram, options); });
  note_segmentation(run, mesh, diagram, segmentation);
  LabelledMesh output{mesh};
  output.face_label = &segmentation.face_label;
  output.vertex_label = &diagram.vertex_label;
  output.vertex_distance = &diagram.vertex_distance;
  output.diagram = &diagram;
  write_files(run, output, [&](std::ostream& out) { write_segmentation_json(out, mesh, diagram, segmentation); });
}

void write_cut_faces(Run& run, const Mesh& mesh, const Diagram& diagram) {
  const CutMesh cut = run.timed("cut", [&] { return cut_faces(mesh, diagram); });
  const CutVertices vertices = carry_to_cut_vertices(mesh, diagram, cut);
  if (cut.uncut_faces > 0) {
    run.console().note(fmt::format("{} could not be cut", counted(cut.uncut_faces, "face", "faces")));
  }
  run.report().results()["uncut_faces"] = cut.uncut_faces;
  note_regions(run, cut.mesh, cut.label, diagram.generators.size());
  LabelledMesh output{cut.mesh};
  output.face_label = &cut.label;
  output.face_parent = &cut.parent;
  output.vertex_label = &vertices.label;
  output.vertex_distance = &vertices.distance;
  output.diagram = &diagram;
  output.diagram_mesh = &mesh;
  write_files(run, output, [&](std::ostream& out) { write_cut_json(out, mesh, diagram, cut, vertices); });
}

void segment(Run& run, const OwnOptions& own) {
  const SegmentOptions options{own.labels.value_or(SegmentOptions().labels)};
  report_options(run, own, options);
  const CheckedMesh input = load_input(run);
  const Mesh& mesh = input.mesh;
  const Diagram diagram = build_diagram(run, mesh, make_generators(run, input));
  if (own.cut) {
    write_cut_faces(run, mesh, diagram);
  } else {
    write_whole_faces(run, mesh, diagram, options);
  }
  write_diagram_file(run, mesh, diagram);
  write_own_file(run, "--stats",
                 [&](std::ostream& out) { write_statistics_csv(out, compute_region_statistics(mesh, diagram)); });
  finish_run(run, mesh, diagram);
}

}  // namespace
}  // namespace gvd::app

int main(int argc, char** argv) {
  using namespace gvd;
  using namespace gvd::app;
  OwnOptions own;
  Command command({"gvd-segment",
                   "Labels every face of a triangle mesh with the region of the geodesically nearest generator.",
                   kExamples,
                   {"ply", "obj", "off", "stl", "vtp", "glb", "json"}});
  command.line().option_defaults()->group("Regions");
  add_flag(command.line(), "--cut", own.cut, "Split faces along the bisectors instead of labelling whole faces");
  add_choice(
      command.line(), "--labels", own.labels, kLabels,
      "How to label whole faces on a bisector: for the shortest borders, or by the largest share (default: smooth)")
      ->excludes("--cut");
  command.add_target("--stats", "FILE.csv", "Write the area, perimeter, radius and neighbours of each region (CSV)");
  return command.run(argc, argv, [&](Run& run) { segment(run, own); });
}
