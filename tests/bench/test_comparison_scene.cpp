#include <algorithm>
#include <string>
#include <vector>

#include "comparison_scene.hpp"
#include "list_comparators.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_comparison_scene {

using namespace paper;

TEST_CASE("every comparator's diagram becomes a scene of one page") {
  if (!has_viewer()) return;
  const Mesh mesh = test::make_plate(8, 0.1);
  const auto generators = test::random_generators(mesh, 8, 1);
  std::vector<ViewScene> scenes;
  for (const Comparator& comparator : list_comparators()) {
    const Comparison found = comparator.run(mesh, generators);
    scenes.push_back(make_comparison_scene(comparator.name, mesh, found));
    CAPTURE(comparator.name);
    CHECK(scenes.back().name == comparator.name);
    CHECK(scenes.back().bisectors.size() == found.diagram.bisectors.size());
    CHECK(scenes.back().generators.size() == 8);
    CHECK(scenes.back().vertex_distance.empty());
    CHECK(scenes.back().cell_energy.empty());
  }
  CHECK(make_view_page(scenes).find("LRVD [28]") != std::string::npos);
}

TEST_CASE("scenes of one page have the same neighbours: those of any of them") {
  const Mesh mesh = test::make_plate(8, 0.01);
  const auto generators = test::random_generators(mesh, 8, 1);
  std::vector<ViewScene> scenes;
  for (const Comparator& comparator : list_comparators({{}, false})) {
    scenes.push_back(make_comparison_scene(comparator.name, mesh, comparator.run(mesh, generators)));
  }
  const std::vector<ViewScene> before = scenes;
  share_neighbours(scenes);
  for (int i = 0; i < 8; ++i) {
    const std::vector<GeneratorId>& all = scenes[0].cells[GeneratorId(i)].neighbours;
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      CHECK(scenes[s].cells[GeneratorId(i)].neighbours == all);
      for (const GeneratorId g : before[s].cells[GeneratorId(i)].neighbours) {
        CHECK(std::find(all.begin(), all.end(), g) != all.end());
      }
    }
  }
  std::vector<ViewScene> none;
  share_neighbours(none);
  CHECK(none.empty());
}

}  // namespace gvd::test_comparison_scene
