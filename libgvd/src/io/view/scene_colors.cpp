// Chooses the colours of a page's scenes: for each scene by itself, except that a scene of a slider follows the scene
// after it.
//
// A scene of a mesh with labels brings its own colours, the same as in its files. Other scenes get the colours that a
// file with the same content would have.
#include "io/view/scene_colors.hpp"

#include <algorithm>
#include <functional>

#include "io/writers/region_colors.hpp"

namespace gvd::io {
namespace {

/// One more than the largest label.
std::size_t count_labels(const ViewScene& scene) {
  std::int64_t labels = std::ssize(scene.cells);
  for (const GeneratorId label : scene.face_label) labels = std::max<std::int64_t>(labels, label.value() + 1);
  for (const FacePiece& piece : scene.pieces) labels = std::max<std::int64_t>(labels, piece.generator.value() + 1);
  return static_cast<std::size_t>(labels);
}

/// Indices of a slider's scenes, from the last iteration back to the first.
std::vector<std::size_t> list_iterations(const std::vector<ViewScene>& scenes) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (scenes[i].iteration) order.push_back(i);
  }
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return *scenes[i].iteration; });
  return order;
}

}  // namespace

std::vector<RegionPair> find_adjacent_regions(const ViewScene& scene) {
  std::vector<RegionPair> pairs;
  if (!scene.face_label.empty()) add_face_neighbours(*scene.mesh, scene.face_label, pairs);
  // Bisectors drawn over uncut faces are not borders. Together with the pairs of faces they could give a graph that
  // can't be drawn on the surface, and that needs more colours.
  if (!scene.pieces.empty()) add_cell_neighbours(scene.cells, pairs);
  sort_pairs(pairs);
  return pairs;
}

std::vector<std::vector<Rgb>> choose_scene_colors(const std::vector<ViewScene>& scenes) {
  std::vector<std::vector<Rgb>> colors(scenes.size());
  const std::vector<Rgb>* later = nullptr;
  for (const std::size_t i : list_iterations(scenes)) {
    const std::size_t count = count_labels(scenes[i]);
    const auto adjacent = find_adjacent_regions(scenes[i]);
    colors[i] = later ? adapt_region_colors(*later, count, adjacent) : choose_region_colors(count, adjacent);
    later = &colors[i];
  }
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (scenes[i].iteration) continue;
    colors[i] = scenes[i].region_color;
    if (colors[i].empty()) colors[i] = choose_region_colors(count_labels(scenes[i]), find_adjacent_regions(scenes[i]));
  }
  return colors;
}

}  // namespace gvd::io
