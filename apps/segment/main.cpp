// gvd-segment: labels the faces of a mesh, or cuts them along the bisectors.

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "common/options/typed_options.hpp"
#include "common/run_parts.hpp"
#include "gvd/counted.hpp"
#include "gvd/region_statistics.hpp"
#include "gvd/segment.hpp"
#include "segment/segment_report.hpp"

namespace {

using namespace gvd;

constexpr const char* kExamples =
    "  gvd-segment bunny.obj -n 30 -o regions.ply\n"
    "  gvd-segment bunny.obj --generators samples.json -o regions.obj --view a.html\n"
    "  gvd-segment scan.stl --radius 2.5 --cut -o pieces.ply --report report.json\n"
    "  gvd-segment - --input-format ply --vertices 3,17,99 -o - < a.ply > b.ply\n"
    "  gvd-segment scans/*.stl -n 30 --output-dir regions --output-format ply,json\n";

constexpr const char* kRegions = "Regions";

/// The options of gvd-segment alone.
struct OwnOptions {
  bool cut = false;
  std::optional<FaceLabels> labels;  ///< of whole faces
};

void report_options(app::Run& run, const OwnOptions& own, const SegmentOptions& options) {
  nlohmann::ordered_json& reported = run.report().options();
  const std::string& stats = run.options().output.own.at("--stats");
  reported["cut"] = own.cut;
  reported["stats"] = stats.empty() ? nullptr : nlohmann::ordered_json(stats);
  const char* const labels = options.labels == FaceLabels::smooth ? "smooth" : "nearest";
  reported["labels"] = own.cut ? nullptr : nlohmann::ordered_json(labels);
}

void note_regions(app::Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count) {
  if (const std::int64_t unreached = app::count_unreached(label); unreached > 0) {
    run.console().note(fmt::format("{} reached by no generator: label -1", counted(unreached, "face is", "faces are")));
  }
  app::report_regions(run.report().results(), mesh, label, count);
}

void write_files(app::Run& run, const LabelledMesh& output, const app::OutputWriter& write_json) {
  app::write_output_files(run, output, {{"json", write_json}});
  app::write_view_file(run, "gvd-segment", [&] { return std::vector{make_view_scene("Regions", output)}; });
}

void note_segmentation(app::Run& run, const Mesh& mesh, const Diagram& diagram, const Segmentation& segmentation) {
  const double borders = compute_border_length(mesh, segmentation.face_label);
  if (!segmentation.without_face.empty()) run.console().note(app::describe_without_face(segmentation.without_face));
  app::report_segmentation(run.report().results(), segmentation);
  if (diagram.length > 0) {
    run.console().detail(
        fmt::format("borders of length {:.6g}, {:.3f} times that of the bisectors", borders, borders / diagram.length));
  }
  app::report_borders(run.report().results(), borders, diagram.length);
  note_regions(run, mesh, segmentation.face_label, diagram.generators.size());
}

void write_whole_faces(app::Run& run, const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options) {
  const Segmentation segmentation = run.timed("segment", [&] { return segment_faces(mesh, diagram, options); });
  note_segmentation(run, mesh, diagram, segmentation);
  LabelledMesh output{mesh};
  output.face_label = &segmentation.face_label;
  output.vertex_label = &diagram.vertex_label;
  output.vertex_distance = &diagram.vertex_distance;
  output.diagram = &diagram;
  write_files(run, output, [&](std::ostream& out) { app::write_segmentation_json(out, mesh, diagram, segmentation); });
}

void write_cut_faces(app::Run& run, const Mesh& mesh, const Diagram& diagram) {
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
  write_files(run, output, [&](std::ostream& out) { app::write_cut_json(out, {mesh, diagram, cut, vertices}); });
}

void segment(app::Run& run, const OwnOptions& own) {
  const SegmentOptions options{own.labels.value_or(SegmentOptions().labels)};
  report_options(run, own, options);
  const CheckedMesh input = app::load_input(run);
  const Mesh& mesh = input.mesh;
  const Diagram diagram = app::build_diagram(run, mesh, app::make_generators(run, input));
  if (own.cut) {
    write_cut_faces(run, mesh, diagram);
  } else {
    write_whole_faces(run, mesh, diagram, options);
  }
  app::write_diagram_file(run, mesh, diagram);
  app::write_own_file(run, "--stats",
                      [&](std::ostream& out) { write_statistics_csv(out, compute_region_statistics(mesh, diagram)); });
  app::finish_run(run, mesh, diagram);
}

}  // namespace

int main(int argc, char** argv) {
  OwnOptions own;
  app::Command command({"gvd-segment",
                        "Labels every face of a triangle mesh with the region of the geodesically nearest generator.",
                        kExamples,
                        {"ply", "obj", "off", "stl", "vtp", "glb", "json"}});
  command.line().add_flag({"--cut", "", "Split faces along the bisectors instead of labelling whole faces", kRegions},
                          own.cut);
  app::OptionText labels{"--labels", "",
                         "Whole faces on a bisector: shortest borders, or largest share (default: smooth)", kRegions};
  labels.excludes = {"--cut"};
  app::add_choice(command.line(), labels, own.labels,
                  app::Choices<FaceLabels>{{"smooth", FaceLabels::smooth}, {"nearest", FaceLabels::nearest}});
  command.add_target({"--stats", "FILE.csv", "Write area, perimeter, radius, neighbours of each region as CSV"});
  return command.run(argc, argv, [&](app::Run& run) { segment(run, own); });
}
