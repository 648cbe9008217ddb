// gvd-segment: labels the faces of a mesh, or cuts them along the bisectors.

#include "common/options/typed_options.hpp"
#include "common/run/command.hpp"
#include "common/steps/build_diagram.hpp"
#include "common/steps/load_input.hpp"
#include "common/steps/make_generators.hpp"
#include "common/steps/verify.hpp"
#include "common/steps/write_outputs.hpp"
#include "gvd/region_statistics.hpp"
#include "gvd/segment.hpp"
#include "segment/segment_json.hpp"
#include "segment/segment_report.hpp"

namespace {

using namespace gvd;

constexpr const char* kExamples =
    "  gvd-segment bunny.obj -n 30 -o regions.ply\n"
    "  gvd-segment bunny.obj --generators samples.json -o regions.obj --view a.html\n"
    "  gvd-segment scan.stl --radius 2.5 --cut -o pieces.ply --report report.json\n"
    "  gvd-segment - --input-format ply --vertices 3,17,99 -o - < a.ply > b.ply\n"
    "  gvd-segment scans/*.stl -n 30 --output-dir regions --output-format ply,json\n";

void write_view(app::Run& run, const LabelledMesh& output) {
  app::write_view_file(run, "gvd-segment", [&] { return std::vector{make_view_scene("Regions", output)}; });
}

void write_whole_faces(app::Run& run, const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options) {
  const Segmentation segmentation = run.timed("segment", [&] { return segment_faces(mesh, diagram, options); });
  app::report_segmentation(run, segmentation);
  app::report_borders(run, compute_border_length(mesh, segmentation.face_label), diagram.length);
  app::report_regions(run, mesh, segmentation.face_label, diagram.generators.size());
  LabelledMesh output{mesh};
  output.face_label = &segmentation.face_label;
  output.vertex_label = &diagram.vertex_label;
  output.vertex_distance = &diagram.vertex_distance;
  output.diagram = &diagram;
  const auto json = [&](std::ostream& out) { app::write_segmentation_json(out, mesh, diagram, segmentation); };
  app::write_output_files(run, output, {{"json", json}});
  write_view(run, output);
}

void write_cut_faces(app::Run& run, const Mesh& mesh, const Diagram& diagram) {
  const CutMesh cut = run.timed("cut", [&] { return cut_faces(mesh, diagram); });
  const CutVertices vertices = carry_to_cut_vertices(mesh, diagram, cut);
  app::report_cut(run, cut);
  app::report_regions(run, cut.mesh, cut.label, diagram.generators.size());
  LabelledMesh output{cut.mesh};
  output.face_label = &cut.label;
  output.face_parent = &cut.parent;
  output.vertex_label = &vertices.label;
  output.vertex_distance = &vertices.distance;
  output.diagram = &diagram;
  output.diagram_mesh = &mesh;
  const auto json = [&](std::ostream& out) { app::write_cut_json(out, {mesh, diagram, cut, vertices}); };
  app::write_output_files(run, output, {{"json", json}});
  write_view(run, output);
}

void segment(app::Run& run, const app::OwnOptions& own) {
  app::report_segment_options(run, own);
  const CheckedMesh input = app::load_input(run);
  const Mesh& mesh = input.mesh;
  const Diagram diagram = app::build_diagram(run, mesh, app::make_generators(run, input));
  if (own.cut) {
    write_cut_faces(run, mesh, diagram);
  } else {
    write_whole_faces(run, mesh, diagram, own.segment_options());
  }
  app::write_diagram_file(run, mesh, diagram);
  app::write_own_file(run, "--stats",
                      [&](std::ostream& out) { write_statistics_csv(out, compute_region_statistics(mesh, diagram)); });
  app::verify(run, mesh, diagram);
  app::write_report_file(run);
}

}  // namespace

int main(int argc, char** argv) {
  app::OwnOptions own;
  app::Command command({"gvd-segment",
                        "Labels every face of a triangle mesh with the region of the geodesically nearest generator.",
                        kExamples,
                        {"ply", "obj", "off", "stl", "vtp", "glb", "json"}});
  command.line().option_defaults()->group("Regions");
  app::add_flag(command.line(), "--cut", own.cut, "Split faces along the bisectors instead of labelling whole faces");
  app::add_choice(command.line(), "--labels", own.labels,
                  app::Choices<FaceLabels>{{"smooth", FaceLabels::smooth}, {"nearest", FaceLabels::nearest}},
                  "Whole faces on a bisector: shortest borders, or largest share (default: smooth)")
      ->excludes("--cut");
  command.add_target("--stats", "FILE.csv", "Write area, perimeter, radius, neighbours of each region as CSV");
  return command.run(argc, argv, [&](app::Run& run) { segment(run, own); });
}
