#include "mesh/repair/repair_components.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/counted.hpp"

namespace gvd {
namespace {

struct Component {
  std::int32_t first_face;
  double twice_area = 0;  // square mesh units
};

double twice_area(const WorkFaces& work, std::int32_t f, const std::vector<Vec3>& positions) {
  const auto& [a, b, c] = work.faces[f];
  const auto at = [&](std::int32_t v) -> const Vec3& { return positions[v]; };
  return (at(b) - at(a)).cross(at(c) - at(a)).stableNorm();
}

// Fills `component`, the number of each face's component.
std::vector<Component> find_components(const WorkFaces& work, const std::vector<Vec3>& positions,
                                       std::vector<std::int32_t>& component) {
  component.assign(work.faces.size(), -1);
  std::vector<Component> components;
  std::vector<std::int32_t> stack;
  for (std::size_t start = 0; start < work.faces.size(); ++start) {
    if (component[start] >= 0) continue;
    const auto id = static_cast<std::int32_t>(components.size());
    components.push_back({static_cast<std::int32_t>(start)});
    component[start] = id;
    stack.push_back(static_cast<std::int32_t>(start));
    while (!stack.empty()) {
      const std::int32_t f = stack.back();
      stack.pop_back();
      components.back().twice_area += twice_area(work, f, positions);
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::int32_t twin = work.twin[h];
        if (twin < 0 || component[twin / 3] >= 0) continue;
        component[twin / 3] = id;
        stack.push_back(twin / 3);
      }
    }
  }
  return components;
}

void keep_faces(WorkFaces& work, const std::vector<std::int32_t>& component, std::int32_t kept) {
  std::vector<std::int32_t> renumbered(work.faces.size(), -1);
  std::int32_t count = 0;
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    if (component[f] == kept) renumbered[f] = count++;
  }
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    if (renumbered[f] < 0) continue;
    const auto to = static_cast<std::size_t>(renumbered[f]);
    work.faces[to] = work.faces[f];
    work.origin[to] = work.origin[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t twin = work.twin[3 * f + i];
      work.twin[3 * to + i] = twin < 0 ? -1 : 3 * renumbered[twin / 3] + twin % 3;
    }
  }
  work.faces.resize(static_cast<std::size_t>(count));
  work.origin.resize(static_cast<std::size_t>(count));
  work.twin.resize(3 * static_cast<std::size_t>(count));
}

}  // namespace

void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log) {
  if (log.policy() != DefectPolicy::largest) return;
  std::vector<std::int32_t> component;
  const std::vector<Component> components = find_components(work, positions, component);
  const auto largest =
      std::max_element(components.begin(), components.end(),
                       [](const Component& a, const Component& b) { return a.twice_area < b.twice_area; });
  const std::int32_t face = work.origin[largest->first_face];
  if (one_sided[largest->first_face]) {
    refuse_soup(
        fmt::format("the largest component, that of face {}, has only one side, like a Moebius strip: cut it open",
                    face),
        face);
  }
  const auto kept = static_cast<std::int32_t>(largest - components.begin());
  const std::int32_t dropped = components[kept == 0 && components.size() > 1 ? 1 : 0].first_face;
  const std::int32_t first = work.origin[dropped];
  keep_faces(work, component, kept);
  const auto count = static_cast<std::int64_t>(components.size()) - 1;
  log.add(DefectKind::dropped_components, count, first,
          fmt::format("{} smaller than the largest, first the one of face {}",
                      counted(count, "component is", "components are"), first),
          "removed");
}

}  // namespace gvd
