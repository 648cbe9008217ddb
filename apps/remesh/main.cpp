#include <fmt/format.h>

#include <cstddef>

#include "common/command.hpp"
#include "common/numbers.hpp"
#include "common/pipeline.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/run_report.hpp"
#include "gvd/remesh.hpp"
#include "remesh_json.hpp"

namespace {

using namespace gvd;

constexpr const char* kExamples =
    "  gvd-remesh bunny.obj -n 2000 -o coarse.obj\n"
    "  gvd-lloyd bunny.obj -n 2000 -o samples.json && gvd-remesh bunny.obj --generators samples.json -o coarse.ply\n"
    "  gvd-remesh bunny.obj -n 500 --view coarse.html --report report.json\n"
    "  gvd-remesh bunny.obj -n 500 --no-refine -o coarse.off\n";

constexpr app::Range<std::int64_t> kMaxAdded{0, 1000000000, "a whole number from 0 to 1000000000"};

struct Settings {
  RemeshOptions remesh;
  bool no_refine = false;
};

void register_options(CLI::App& cli, Settings& settings) {
  const std::string group = "Remesh";
  app::add_number<std::int64_t>(cli, "--max-added", settings.remesh.max_added, kMaxAdded,
                                "Most generators that may be added (default: ten for each given one, component, "
                                "boundary loop and handle, and 100 more)")
      ->group(group);
  cli.add_flag("--no-refine", settings.no_refine,
               "Add no generators: refuse where the dual of the given ones is no proper mesh")
      ->group(group);
}

nlohmann::ordered_json to_json(const MeshSummary& s) {
  return {{"vertices", s.vertices},
          {"faces", s.faces},
          {"components", s.components},
          {"boundary_loops", s.boundary_loops},
          {"euler_characteristic", s.euler_characteristic},
          {"area", s.area}};
}

nlohmann::ordered_json to_json(const TriangleQuality& q) {
  return {{"q_min", q.q_min},
          {"q_average", q.q_average},
          {"angle_min", q.angle_min},
          {"angle_min_average", q.angle_min_average},
          {"percent_below_30", q.percent_below_30}};
}

nlohmann::ordered_json to_json(const RemeshCertificate& c) {
  return {{"manifold", c.manifold},
          {"closed_as_input", c.closed_as_input},
          {"same_euler_characteristic", c.same_euler_characteristic},
          {"same_components", c.same_components},
          {"same_boundary_loops", c.same_boundary_loops},
          {"same_in_each_component", c.same_in_each_component},
          {"flipped_faces", c.flipped_faces},
          {"unused_generators", c.unused_generators}};
}

void report_remesh(app::Run& run, const Mesh& mesh, const RemeshResult& result) {
  auto& results = run.results();
  results["added_generators"] = result.added;
  results["rounds"] = result.rounds;
  results["output"] = to_json(result.certificate.output);
  results["certificate"] = to_json(result.certificate);
  results["quality"] = {{"input", to_json(result.input_quality)}, {"output", to_json(result.output_quality)}};
  run.report().diagram = summarize_diagram(result.diagram);
  // Those that were given stand in the report already.
  for (std::size_t i = run.report().generators.size(); i < result.generators.size(); ++i) {
    const SurfacePoint& p = result.generators[i];
    run.report().generators.push_back({p, position(mesh, p), std::nullopt});
  }
  run.console().note(fmt::format("{} vertices, {} faces: manifold, with the input's topology",
                                 result.mesh.vertex_count(), result.mesh.face_count()));
  if (result.added > 0) {
    run.console().note(fmt::format("{} generators were added, for the dual of the given {} is no proper mesh",
                                   result.added, result.generators.size() - static_cast<std::size_t>(result.added)));
  }
}

RemeshResult make_remesh(app::Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                         Settings settings) {
  run.reported_options()["max_added"] =
      settings.remesh.max_added.value_or(default_max_added(compute_mesh_summary(mesh), generators.size()));
  run.reported_options()["no_refine"] = settings.no_refine;
  settings.remesh.refine = !settings.no_refine;
  settings.remesh.diagram = app::make_diagram_options(run.options().compute);
  settings.remesh.diagram.progress = run.progress();
  RemeshResult result = run.timed("diagram", [&] { return remesh(mesh, generators, settings.remesh); });
  report_remesh(run, mesh, result);
  return result;
}

/// Parts the added generators, which come last, from the given ones.
void mark_added(const RemeshResult& result, ViewScene& scene) {
  const auto first = scene.generators.end() - static_cast<std::ptrdiff_t>(result.added);
  scene.added_generators.assign(first, scene.generators.end());
  scene.generators.erase(first, scene.generators.end());
}

ViewScene diagram_scene(const Mesh& mesh, const RemeshResult& result) {
  ViewScene scene = make_view_scene("Diagram", mesh, result.diagram);
  mark_added(result, scene);
  return scene;
}

ViewScene coarse_scene(const RemeshResult& result) {
  ViewScene scene;
  scene.name = "Remesh";
  scene.mesh = &result.mesh;
  scene.generators = result.mesh.positions();  // vertex i is generator i
  mark_added(result, scene);
  scene.wireframe = true;
  scene.smooth = false;
  scene.figures = {{"Vertices", fmt::format("{}", result.mesh.vertex_count())},
                   {"Faces", fmt::format("{}", result.mesh.face_count())},
                   {"Generators added", fmt::format("{}", result.added)},
                   {"Euler characteristic", fmt::format("{}", result.certificate.output.euler_characteristic)},
                   {"Mean quality Q", fmt::format("{:.3f}", result.output_quality.q_average)},
                   {"Angles below 30 degrees", fmt::format("{:.1f} %", result.output_quality.percent_below_30)}};
  return scene;
}

void run_remesh(app::Run& run, const Settings& settings) {
  const CheckedMesh input = app::load_input(run);
  const Mesh& mesh = input.mesh;
  const std::vector<SurfacePoint> generators = app::make_generators(run, input);
  const RemeshResult result = make_remesh(run, mesh, generators, settings);
  const auto json = [&](std::ostream& out) { write_remesh_json(out, mesh, result); };
  app::write_output_files(run, LabelledMesh{result.mesh}, {{"json", json}});
  app::write_diagram_file(run, mesh, result.diagram);
  app::write_view_file(run, "gvd-remesh", [&] {
    return std::vector{coarse_scene(result), diagram_scene(mesh, result)};
  });
  app::verify(run, mesh, result.diagram);
  app::write_report_file(run);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  app::Command command({"gvd-remesh",
                        "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point.",
                        kExamples,
                        {"ply", "obj", "off", "stl", "vtp", "glb", "json"}});
  register_options(command.cli(), settings);
  return command.run(argc, argv, [&](app::Run& run) { run_remesh(run, settings); });
}
