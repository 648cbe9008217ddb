#include <fmt/format.h>

#include <algorithm>

#include "common/command.hpp"
#include "common/pipeline.hpp"
#include "gvd/segment.hpp"
#include "segment_json.hpp"

namespace {

using namespace gvd;

constexpr const char* kExamples =
    "  gvd-segment bunny.obj -n 30 -o regions.ply\n"
    "  gvd-segment bunny.obj --generators samples.json -o regions.obj --view regions.html\n"
    "  gvd-segment scan.stl --radius 2.5 --cut -o pieces.ply --report report.json\n"
    "  gvd-segment - --input-format ply --vertices 3,17,99 -o - < mesh.ply > regions.ply\n";

nlohmann::ordered_json list(const std::vector<GeneratorId>& ids) {
  auto array = nlohmann::ordered_json::array();
  for (const GeneratorId id : ids) array.push_back(id.value());
  return array;
}

/// Names some of them: a list as long as the generators' own belongs into the report.
void tell_unowned(app::Run& run, const std::vector<GeneratorId>& unowned) {
  constexpr std::size_t kNamed = 8;
  if (unowned.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(kNamed, unowned.size()); ++i) {
    names += fmt::format("{}{}", i > 0 ? ", " : "", unowned[i].value());
  }
  if (unowned.size() > kNamed) names += ", ...";
  run.console().note(fmt::format("{} of the generators own no face, their cells lie inside faces of other regions: {}",
                                 unowned.size(), names));
}

/// The figures of every region, for the report.
nlohmann::ordered_json regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count) {
  std::vector<std::int64_t> faces(count, 0);
  std::vector<double> area(count, 0);
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const GeneratorId g = label[FaceId(i)];
    if (!g.valid()) continue;
    ++faces[g.index()];
    area[g.index()] += mesh.area(FaceId(i));
  }
  auto array = nlohmann::ordered_json::array();
  for (std::size_t g = 0; g < count; ++g) array.push_back({{"label", g}, {"faces", faces[g]}, {"area", area[g]}});
  return array;
}

void report(app::Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count) {
  std::int64_t unreached = 0;
  for (const GeneratorId g : label) unreached += !g.valid();
  if (unreached > 0) run.console().note(fmt::format("{} faces are reached by no generator: label -1", unreached));
  run.results()["faces"] = mesh.face_count();
  run.results()["unreached_faces"] = unreached;
  run.results()["regions"] = regions(mesh, label, count);
}

void write_whole_faces(app::Run& run, const Mesh& mesh, const Diagram& diagram) {
  const Segmentation segmentation = run.timed("segment", [&] { return segment_faces(mesh, diagram); });
  tell_unowned(run, segmentation.without_face);
  run.results()["generators_without_face"] = list(segmentation.without_face);
  run.results()["moved_faces"] = segmentation.moved_faces;
  run.results()["given_faces"] = segmentation.given_faces;
  report(run, mesh, segmentation.face_label, diagram.generators.size());
  LabelledMesh output{mesh};
  output.face_label = &segmentation.face_label;
  output.vertex_label = &diagram.vertex_label;
  output.vertex_distance = &diagram.vertex_distance;
  output.diagram = &diagram;
  const auto json = [&](std::ostream& out) { write_segmentation_json(out, mesh, diagram, segmentation); };
  app::write_output_files(run, output, {{"json", json}});
}

void write_cut_faces(app::Run& run, const Mesh& mesh, const Diagram& diagram) {
  const CutMesh cut = run.timed("cut", [&] { return cut_faces(mesh, diagram); });
  if (cut.uncut_faces > 0) run.console().note(fmt::format("{} faces could not be cut", cut.uncut_faces));
  run.results()["uncut_faces"] = cut.uncut_faces;
  report(run, cut.mesh, cut.label, diagram.generators.size());
  LabelledMesh output{cut.mesh};
  output.face_label = &cut.label;
  output.face_parent = &cut.parent;
  output.diagram = &diagram;
  output.diagram_mesh = &mesh;
  const auto json = [&](std::ostream& out) { write_cut_json(out, mesh, diagram, cut); };
  app::write_output_files(run, output, {{"json", json}});
}

void segment(app::Run& run, bool cut) {
  run.reported_options()["cut"] = cut;
  const CheckedMesh input = app::load_input(run);
  const Mesh& mesh = input.mesh;
  const Diagram diagram = app::build_diagram(run, mesh, app::make_generators(run, input));
  if (cut) {
    write_cut_faces(run, mesh, diagram);
  } else {
    write_whole_faces(run, mesh, diagram);
  }
  app::write_diagram_file(run, mesh, diagram);
  app::write_view_file(run, "gvd-segment", [&] { return std::vector{make_view_scene("Regions", mesh, diagram)}; });
  app::verify(run, mesh, diagram);
  app::write_report_file(run);
}

}  // namespace

int main(int argc, char** argv) {
  bool cut = false;
  app::Command command({"gvd-segment",
                        "Labels every face of a triangle mesh with the region of the geodesically nearest generator.",
                        kExamples,
                        {"ply", "obj", "off", "stl", "vtp", "glb", "json"}});
  command.cli().add_flag("--cut", cut, "Split faces along the bisectors instead of labelling whole faces");
  return command.run(argc, argv, [&](app::Run& run) { segment(run, cut); });
}
