#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "bench/comparisons.hpp"
#include "comparators.hpp"
#include "judge.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_comparators {

using namespace paper;

TEST_CASE("every comparator has a name of its own and fills a diagram that the same E judges") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::vertex_points(mesh, 10, 1, 60);
  const Judge judge(mesh, generators);
  std::set<std::string> names;
  for (const Comparator& comparator : list_comparators()) {
    INFO(comparator.name);
    CHECK(names.insert(comparator.name).second);
    const Comparison found = comparator.run(mesh, generators);
    CHECK(found.diagram.generators == generators);
    CHECK(found.diagram.bisectors.size() > 10);
    CHECK(found.diagram.face_label.size() == std::size_t(mesh.face_count()));
    CHECK(found.field_ms + found.diagram_ms > 0);
    const Judgement judgement = judge.judge(found.diagram);
    CHECK(judgement.error.length == Approx(found.diagram.length).epsilon(1e-6));
    CHECK(std::isfinite(judgement.error.error_integral));
    CHECK(double(judgement.wrong_labels) < 0.2 * double(judgement.labelled));
  }
  CHECK(names.size() == 9);
}

TEST_CASE("the exact method has the least error, and windows with straight segments the next") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::vertex_points(mesh, 10, 1, 60);
  const Judge judge(mesh, generators);
  std::vector<double> error;
  for (const Comparator& comparator : list_comparators({{}, false})) {
    error.push_back(judge.judge(comparator.run(mesh, generators).diagram).error.error_integral);
  }
  REQUIRE(error.size() == 8);
  const double exact = error[0], windows = error[4];
  CHECK(exact < windows);
  for (const std::size_t other : {1, 2, 3, 5, 6, 7}) CHECK(windows < error[other]);
}

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

}  // namespace gvd::test_comparators
