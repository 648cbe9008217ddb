// Colours of the scenes of a slider: a region keeps its colour as far as neighbours still differ.
#include <algorithm>
#include <cmath>

#include "gvd/geodesic_tracing.hpp"
#include "io/view/region_colors.hpp"
#include "io/view/scene_colors.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_scene_colors {

using namespace test;

using Pairs = std::vector<std::pair<GeneratorId, GeneratorId>>;

Pairs pairs_of(const std::vector<std::pair<int, int>>& given) {
  Pairs pairs;
  for (const auto& [a, b] : given) pairs.emplace_back(GeneratorId(a), GeneratorId(b));
  return pairs;
}

std::vector<Rgb> colors_of(const std::vector<std::size_t>& choice) {
  std::vector<Rgb> colors;
  for (const std::size_t c : choice) colors.push_back(io::kRegionPalette[c]);
  return colors;
}

bool neighbours_differ(const std::vector<Rgb>& colors, const Pairs& pairs) {
  return std::none_of(pairs.begin(), pairs.end(),
                      [&](const auto& pair) { return colors[pair.first.index()] == colors[pair.second.index()]; });
}

std::ptrdiff_t count_kept(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
  std::ptrdiff_t kept = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) kept += a[i] == b[i];
  return kept;
}

/// Scenes as generators move, each a little from where it was before; the iterations count upwards.
std::vector<ViewScene> make_scenes(const Mesh& mesh, int generators, std::int64_t count) {
  std::vector<SurfacePoint> points = random_generators(mesh, generators, 4);
  std::vector<ViewScene> scenes;
  for (std::int64_t k = 0; k < count; ++k) {
    scenes.push_back(make_view_scene("", mesh, compute_diagram(mesh, points)));
    scenes.back().iteration = k;
    const double step = 0.02 * mesh.bbox_diagonal();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle = double(i + std::size_t(k));
      points[i] = trace_geodesic(mesh, points[i], step * Vec2(std::cos(angle), std::sin(angle))).points.back();
    }
  }
  return scenes;
}

TEST_CASE("colours without a clash are kept, and one of two neighbours with the same colour changes") {
  const std::vector<Rgb> before = colors_of({0, 1, 2, 1});
  CHECK(io::adapt_region_colors(before, 4, pairs_of({{0, 1}, {1, 2}, {2, 3}})) == before);
  const Pairs clash = pairs_of({{0, 1}, {1, 3}, {2, 3}});
  const std::vector<Rgb> after = io::adapt_region_colors(before, 4, clash);
  CHECK(neighbours_differ(after, clash));
  CHECK(count_kept(before, after) == 3);
}

TEST_CASE("labels come and go") {
  const Pairs pairs = pairs_of({{0, 1}, {1, 2}, {0, 2}});
  const std::vector<Rgb> more = io::adapt_region_colors(colors_of({3, 4}), 3, pairs);
  REQUIRE(more.size() == 3);
  CHECK(count_kept(more, colors_of({3, 4})) == 2);
  CHECK(neighbours_differ(more, pairs));
  CHECK(io::adapt_region_colors(more, 2, pairs_of({{0, 1}})) == colors_of({3, 4}));
  CHECK(io::adapt_region_colors(more, 0, {}).empty());
}

TEST_CASE("a region with all usual colours round it takes the colour of a neighbour, which takes another one") {
  // Label 0 has that of label 7, and labels 1 to 7 all usual ones; each of these has no other neighbour.
  Pairs pairs;
  for (int i = 1; i < 8; ++i) pairs.emplace_back(GeneratorId(0), GeneratorId(i));
  const std::vector<Rgb> before = colors_of({6, 0, 1, 2, 3, 4, 5, 6});
  const std::vector<Rgb> after = io::adapt_region_colors(before, 8, pairs);
  CHECK(neighbours_differ(after, pairs));
  CHECK(count_kept(before, after) >= 6);
}

TEST_CASE("dark colours go where a usual one will do, and come where regions need them") {
  const Pairs pair = pairs_of({{0, 1}});
  CHECK(io::adapt_region_colors(colors_of({0, 8}), 2, pair)[0] == io::kRegionPalette[0]);
  CHECK(io::adapt_region_colors(colors_of({0, 8}), 2, pair)[1] != io::kRegionPalette[8]);
  Pairs all;
  for (int a = 0; a < 9; ++a) {
    for (int b = a + 1; b < 9; ++b) all.emplace_back(GeneratorId(a), GeneratorId(b));
  }
  CHECK(neighbours_differ(io::adapt_region_colors(colors_of({0, 1, 2, 3, 4, 5, 6, 0, 1}), 9, all), all));
}

TEST_CASE("a region keeps its colour over the slider, and neighbours differ at each of its positions") {
  for (const auto& [name, mesh] : small_family()) {
    const std::vector<ViewScene> scenes = make_scenes(mesh, 40, 6);
    const auto colors = io::choose_scene_colors(scenes);
    REQUIRE(colors.size() == 6);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      INFO(name << ", iteration " << k);
      CHECK(neighbours_differ(colors[k], io::find_adjacent_regions(scenes[k])));
      if (k > 0) CHECK(count_kept(colors[k - 1], colors[k]) >= 32);
    }
    CHECK(colors.back() == io::choose_region_colors(40, io::find_adjacent_regions(scenes.back())));
  }
}

TEST_CASE("scenes that are no iterations, and the order of scenes in the page, change no colour of a slider") {
  const Mesh mesh = make_sphere(3);
  std::vector<ViewScene> scenes = make_scenes(mesh, 30, 3);
  const auto before = io::choose_scene_colors(scenes);
  ViewScene other = make_view_scene("other", mesh, compute_diagram(mesh, random_generators(mesh, 7, 1)));
  std::reverse(scenes.begin(), scenes.end());
  scenes.insert(scenes.begin() + 1, other);
  const auto after = io::choose_scene_colors(scenes);
  CHECK(after[0] == before[2]);
  CHECK(after[1] == io::choose_region_colors(7, io::find_adjacent_regions(other)));
  CHECK(after[2] == before[1]);
  CHECK(after[3] == before[0]);
}

}  // namespace gvd::test_scene_colors
