// Orients each component of a soup's triangles consistently, and drops components.
//
// A breadth-first search orients each face of a component relative to the first face; then the majority decides. If a
// face would need both orientations, the surface is one-sided. The largest component is the component with the largest
// area; among equal ones, the first is kept. Edges of three or more faces do not connect components. They are cut apart
// later, when all their faces are oriented.
#include "mesh/repair/soup_components.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "gvd/text.hpp"

namespace gvd {
namespace {

/// Faces connected through edges of two faces, in the order of a breadth-first search from the first face.
struct OrientedComponent {
  std::vector<std::int32_t> faces;
  std::int32_t flipped = 0;    // number of `faces` with the opposite orientation of the first
  std::int32_t conflict = -1;  // a face that would need both orientations
};

/// Finds the component of `start`. Sets side[f] to 0 if f has the orientation of `start`, and to 1 if it has the
/// opposite one.
OrientedComponent walk_component(const WorkFaces& work, std::int32_t start, std::vector<signed char>& side) {
  OrientedComponent component;
  component.faces.push_back(start);
  side[start] = 0;
  for (std::size_t i = 0; i < component.faces.size(); ++i) {
    const std::int32_t f = component.faces[i];
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::int32_t twin = work.twin[h];
      if (twin < 0) continue;
      const bool same_direction = work.from(h) == work.from(twin);
      const signed char wanted = same_direction ? !side[f] : side[f];
      signed char& other = side[twin / 3];
      if (other < 0) {
        other = wanted;
        component.flipped += wanted;
        component.faces.push_back(twin / 3);
      } else if (other != wanted && component.conflict < 0) {
        component.conflict = std::max(f, twin / 3);
      }
    }
  }
  return component;
}

/// Reverses a face by swapping its last two corners: its halfedges 0, 1, 2 become 2, 1, 0.
void flip(WorkFaces& work, std::int32_t f) {
  auto& corners = work.faces[f];
  std::swap(corners[1], corners[2]);
  std::swap(work.twin[3 * f], work.twin[3 * f + 2]);
  for (const std::int32_t moved : {3 * f, 3 * f + 2}) {
    if (work.twin[moved] >= 0) work.twin[work.twin[moved]] = moved;
  }
}

[[noreturn]] void refuse_one_sided(const WorkFaces& work, const OrientedComponent& component) {
  const std::int32_t first = *std::min_element(component.faces.begin(), component.faces.end());
  const std::int32_t origin = work.origin[first];
  refuse_soup(
      fmt::format("the component of face {} has only one side, like a Moebius strip (seen at face {}): cut it open",
                  origin, work.origin[component.conflict]),
      origin);
}

struct Component {
  std::int32_t first_face;
  double twice_area = 0;  // square mesh units
};

double twice_area(const WorkFaces& work, std::int32_t f, const std::vector<Vec3>& positions) {
  const auto& [a, b, c] = work.faces[f];
  const auto at = [&](std::int32_t v) -> const Vec3& { return positions[v]; };
  return (at(b) - at(a)).cross(at(c) - at(a)).stableNorm();
}

/// Whether a face counts as having no area. These are the faces that `count_faces_below` counts in the finished mesh.
///
/// Nearly all faces are decided by a quick test without roots and scaling. Its bound is at least twice the exact bound
/// on twice the area, because 2 (|ab|^2 + |ac|^2) is at least the square of each side, including bc. The smallest
/// normal number makes the quick test fail if squares underflow.
bool is_without_area(const WorkFaces& work, std::int32_t f) {
  const auto& [a, b, c] = work.faces[f];
  const Vec3 ab = work.positions[b] - work.positions[a], ac = work.positions[c] - work.positions[a];
  const double bound = 4 * kHeightWithoutArea * (ab.squaredNorm() + ac.squaredNorm());
  const double squared = ab.cross(ac).squaredNorm();
  if (squared > bound * bound + std::numeric_limits<double>::min()) return false;
  const double longest =
      std::max({ab.stableNorm(), ac.stableNorm(), (work.positions[c] - work.positions[b]).stableNorm()});
  return twice_area(work, f, work.positions) <= kHeightWithoutArea * longest * longest;
}

/// Finds the components, in the order of their first faces. Fills `component` with the number of each face's component.
std::vector<Component> find_components(const WorkFaces& work, const std::vector<Vec3>& positions,
                                       std::vector<std::int32_t>& component) {
  component.assign(work.faces.size(), -1);
  std::vector<Component> components;
  std::vector<std::int32_t> stack;
  for (std::int32_t start = 0; start < work.face_count(); ++start) {
    if (component[start] >= 0) continue;
    components.push_back({start});
    component[start] = std::int32_t(components.size() - 1);
    stack.push_back(start);
    while (!stack.empty()) {
      const std::int32_t f = stack.back();
      stack.pop_back();
      components.back().twice_area += twice_area(work, f, positions);
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::int32_t twin = work.twin[h];
        if (twin < 0 || component[twin / 3] >= 0) continue;
        component[twin / 3] = component[start];
        stack.push_back(twin / 3);
      }
    }
  }
  return components;
}

/// Keeps only the faces of components with a 1 in `kept`.
void keep_faces(WorkFaces& work, const std::vector<std::int32_t>& component, const std::vector<char>& kept) {
  std::vector<std::int32_t> renumbered(work.faces.size(), -1);
  std::int32_t count = 0;
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    if (kept[component[f]]) renumbered[f] = count++;
  }
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    const std::int32_t to = renumbered[f];
    if (to < 0) continue;
    work.faces[to] = work.faces[f];
    work.origin[to] = work.origin[f];
    for (int i = 0; i < 3; ++i) {
      const std::int32_t twin = work.twin[3 * f + i];
      work.twin[3 * to + i] = twin < 0 ? -1 : 3 * renumbered[twin / 3] + twin % 3;
    }
  }
  work.faces.resize(count);
  work.origin.resize(count);
  work.twin.resize(3 * count);
}

}  // namespace

std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log) {
  std::vector<char> to_flip(work.faces.size(), 0), one_sided(work.faces.size(), 0);
  std::vector<signed char> side(work.faces.size(), -1);
  for (std::int32_t start = 0; start < work.face_count(); ++start) {
    if (side[start] >= 0) continue;
    const OrientedComponent component = walk_component(work, start, side);
    if (component.conflict >= 0) {
      if (log.policy() != DefectPolicy::largest) refuse_one_sided(work, component);
      for (const std::int32_t f : component.faces) one_sided[f] = 1;
      continue;
    }
    const bool against_first = 2 * std::size_t(component.flipped) > component.faces.size();
    for (const std::int32_t f : component.faces) to_flip[f] = (side[f] == 1) != against_first;
  }
  std::int64_t count = 0;
  std::int32_t first = -1;
  std::int32_t last = -1;
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    if (!to_flip[f]) continue;
    flip(work, f);
    if (first < 0) first = work.origin[f];
    count += work.origin[f] != last;  // several triangles of one polygon count once
    last = work.origin[f];
  }
  for (std::vector<std::int32_t>& halfedges : nonmanifold_edges) {
    for (std::int32_t& h : halfedges) {
      if (to_flip[h / 3]) h = 3 * (h / 3) + 2 - h % 3;
    }
  }
  log.add(DefectKind::inconsistent_orientation, count, first,
          fmt::format("{}, first face {}",
                      counted(count, "face is oriented against most of its component",
                              "faces are oriented against most of their component"),
                      first),
          "flipped");
  return one_sided;
}

void drop_zero_area_components(WorkFaces& work, DefectLog& log) {
  std::vector<char> without_area(work.faces.size());
  for (std::int32_t f = 0; f < work.face_count(); ++f) without_area[f] = is_without_area(work, f);
  if (std::count(without_area.begin(), without_area.end(), 1) == 0) return;
  std::vector<std::int32_t> component;
  const std::vector<Component> components = find_components(work, work.positions, component);
  std::vector<char> has_area(components.size(), 0);
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    if (!without_area[f]) has_area[component[f]] = 1;
  }
  const std::int64_t count = std::count(has_area.begin(), has_area.end(), 0);
  if (count == 0 || count == std::ssize(components)) return;
  const auto dropped = std::find(has_area.begin(), has_area.end(), 0) - has_area.begin();
  const std::int32_t first = work.origin[components[dropped].first_face];
  keep_faces(work, component, has_area);
  log.add(DefectKind::zero_area_components, count, first,
          fmt::format("{} of faces without area only, first the one of face {}",
                      counted(count, "component consists", "components consist"), first),
          "removed");
}

void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log) {
  if (log.policy() != DefectPolicy::largest) return;
  std::vector<std::int32_t> component;
  const std::vector<Component> components = find_components(work, positions, component);
  const auto largest = std::ranges::max_element(components, {}, &Component::twice_area);
  const std::int32_t face = work.origin[largest->first_face];
  if (one_sided[largest->first_face]) {
    refuse_soup(
        fmt::format("the largest component, that of face {}, has only one side, like a Moebius strip: cut it open",
                    face),
        face);
  }
  const auto kept = largest - components.begin();
  const std::int32_t dropped = components[kept == 0 && components.size() > 1 ? 1 : 0].first_face;
  const std::int32_t first = work.origin[dropped];
  std::vector<char> is_kept(components.size(), 0);
  is_kept[std::size_t(kept)] = 1;
  keep_faces(work, component, is_kept);
  const std::int64_t count = std::ssize(components) - 1;
  log.add(DefectKind::dropped_components, count, first,
          fmt::format("{} smaller than the largest, first the one of face {}",
                      counted(count, "component is", "components are"), first),
          "removed");
}

}  // namespace gvd
