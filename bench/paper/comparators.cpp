// All methods by name: those of this library, and those that the paper compares itself with.
//
// The library's methods run on one thread, as the comparators do, and report the times of their steps in two parts, as
// the paper's tables have them: GDF, until distances are known, and VD, after. The paper's own figures come from growth
// with planar fronts; circle fronts and the exact tracer are ours. Nobody's program is run: each comparator is written
// from its paper, so that all work on the same mesh, generators and machine.
// Scenes show diagrams without distances; cells have one colour in all scenes, because each cell gets the neighbours
// that it has in any of them.
#include "comparators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "clocks.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "rvd.hpp"

namespace gvd::paper {

namespace {

bool is_of_field(const std::string& step) {
  return step == steps::kWorkingMesh || step == steps::kDistances || step == steps::kTables;
}

using Points = std::vector<SurfacePoint>;

Comparison run_library_method(const Mesh& mesh, const Points& generators, DiagramOptions options) {
  Comparison result;
  bench::StepClock clock;
  options.threads = 1;
  options.progress = clock.progress();
  result.diagram = compute_diagram(mesh, generators, options);
  for (const auto& [step, milliseconds] : clock.finish()) {
    (is_of_field(step) ? result.field_ms : result.diagram_ms) += milliseconds;
  }
  for (const Cell& cell : result.diagram.cells) result.faults.islands += std::max(0, cell.components - 1);
  result.faults.open_ends = result.diagram.report.unresolved_ends;
  return result;
}

Comparator library_method(const std::string& name, const Method& method, Front front = Front::circle) {
  DiagramOptions options;
  options.method = method;
  options.front = front;
  return {name, [options](const Mesh& mesh, const Points& generators) {
            return run_library_method(mesh, generators, options);
          }};
}

Comparator window_voronoi(const std::string& name, const WindowVoronoiOptions& options) {
  return {name, [options](const Mesh& mesh, const Points& generators) {
            return compute_window_voronoi(mesh, generators, options);
          }};
}

}  // namespace

std::vector<Comparator> list_comparators(const ComparatorOptions& options) {
  std::vector<Comparator> all{library_method("exact", Method::exact), library_method("gbgvd circle", Method::gbgvd),
                              library_method("gbgvd planar", Method::gbgvd, Front::planar),
                              library_method("paper's steps", Method::paper, Front::planar),
                              window_voronoi("windows [27]", {})};
  if (options.unpruned_windows) all.push_back(window_voronoi("unpruned [27]", {true}));
  all.push_back({"diffusion [8]", [diffusion = options.diffusion](const Mesh& mesh, const Points& generators) {
                   return compute_diffusion(mesh, generators, diffusion);
                 }});
  all.push_back({"RVD [29]", compute_rvd});
  all.push_back(
      {"LRVD [28]", [](const Mesh& mesh, const Points& generators) { return compute_lrvd(mesh, generators); }});
  return all;
}

std::vector<Comparator> pick_comparators(const std::vector<std::string>& names, const ComparatorOptions& options) {
  std::vector<Comparator> all = list_comparators(options);
  if (names.empty()) return all;
  std::vector<Comparator> picked;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, &Comparator::name);
    if (found == all.end()) {
      throw Error(ErrorCode::invalid_option,
                  fmt::format("no method is named '{}'; without --methods all are listed", name));
    }
    picked.push_back(*found);
  }
  return picked;
}

ViewScene make_comparison_scene(std::string name, const Mesh& mesh, const Comparison& comparison) {
  Diagram diagram = comparison.diagram;
  // A scene asks for the distance of every vertex. What follows from them is taken out again.
  diagram.vertex_distance.assign(mesh.vertex_count(), kInfinity);
  ViewScene scene = make_view_scene(std::move(name), mesh, diagram);
  scene.vertex_distance = {};
  scene.cell_energy = {};
  scene.figures = {{"Faces", fmt::format("{}", mesh.face_count())},
                   {"Generators", fmt::format("{}", diagram.generators.size())},
                   {"Bisector length", fmt::format("{:.6g}", diagram.length)},
                   {"Islands", fmt::format("{}", comparison.faults.islands)},
                   {"Open ends", fmt::format("{}", comparison.faults.open_ends)}};
  return scene;
}

void share_neighbours(std::vector<ViewScene>& scenes) {
  if (scenes.empty()) return;
  for (const GeneratorId g : scenes.front().cells.ids()) {
    std::set<GeneratorId> all;
    for (const ViewScene& scene : scenes)
      all.insert(scene.cells[g].neighbours.begin(), scene.cells[g].neighbours.end());
    for (ViewScene& scene : scenes) scene.cells[g].neighbours.assign(all.begin(), all.end());
  }
}

}  // namespace gvd::paper
