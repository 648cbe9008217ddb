#include "comparison_scene.hpp"

#include <fmt/format.h>

#include <limits>
#include <set>
#include <utility>

namespace gvd::paper {

ViewScene make_comparison_scene(std::string name, const Mesh& mesh, const Comparison& comparison) {
  Diagram diagram = comparison.diagram;
  // A scene asks for the distance of every vertex. What follows from them is taken out again.
  diagram.vertex_distance.assign(static_cast<std::size_t>(mesh.vertex_count()),
                                 std::numeric_limits<double>::infinity());
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
  for (std::size_t i = 0; i < scenes.front().cells.size(); ++i) {
    const GeneratorId g(i);
    std::set<GeneratorId> all;
    for (const ViewScene& scene : scenes)
      all.insert(scene.cells[g].neighbours.begin(), scene.cells[g].neighbours.end());
    for (ViewScene& scene : scenes) scene.cells[g].neighbours.assign(all.begin(), all.end());
  }
}

}  // namespace gvd::paper
