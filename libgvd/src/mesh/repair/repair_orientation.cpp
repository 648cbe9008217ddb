#include "mesh/repair/repair_orientation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/counted.hpp"

namespace gvd {
namespace {

// Faces that are connected through edges of two faces, in the order of a breadth-first search from the first one.
struct OrientedComponent {
  std::vector<std::int32_t> faces;
  std::int32_t flipped = 0;    // number of `faces` with the opposite orientation of the first
  std::int32_t conflict = -1;  // a face that would need both orientations
};

// Finds the component of `start`. Sets side[f] to 0 where f has the orientation of `start`, to 1 where the opposite
// one.
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
      const auto wanted = static_cast<signed char>(side[f] ^ (same_direction ? 1 : 0));
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

// Reverses a face by swapping its last two corners: its halfedges 0, 1, 2 become 2, 1, 0.
void flip(WorkFaces& work, std::int32_t f) {
  auto& corners = work.faces[f];
  std::swap(corners[1], corners[2]);
  const auto h = static_cast<std::size_t>(3 * f);
  std::swap(work.twin[h], work.twin[h + 2]);
  for (const std::size_t moved : {h, h + 2}) {
    if (work.twin[moved] >= 0) work.twin[work.twin[moved]] = static_cast<std::int32_t>(moved);
  }
}

void refuse_one_sided(const WorkFaces& work, const OrientedComponent& component) {
  const std::int32_t first = *std::min_element(component.faces.begin(), component.faces.end());
  const std::int32_t origin = work.origin[first];
  refuse_soup(
      fmt::format("the component of face {} has only one side, like a Moebius strip (seen at face {}): cut it open",
                  origin, work.origin[component.conflict]),
      origin);
}

struct Orientations {
  std::vector<char> to_flip;    // per face
  std::vector<char> one_sided;  // per face whether its component has one side only
};

Orientations find_orientations(const WorkFaces& work, DefectPolicy policy) {
  Orientations result{std::vector<char>(work.faces.size(), 0), std::vector<char>(work.faces.size(), 0)};
  std::vector<signed char> side(work.faces.size(), -1);
  for (std::size_t start = 0; start < work.faces.size(); ++start) {
    if (side[start] >= 0) continue;
    const OrientedComponent component = walk_component(work, static_cast<std::int32_t>(start), side);
    if (component.conflict >= 0) {
      if (policy != DefectPolicy::largest) refuse_one_sided(work, component);
      for (const std::int32_t f : component.faces) result.one_sided[f] = 1;
      continue;
    }
    const bool against_first = 2 * static_cast<std::size_t>(component.flipped) > component.faces.size();
    for (const std::int32_t f : component.faces) {
      result.to_flip[f] = (side[f] == 1) != against_first;
    }
  }
  return result;
}

}  // namespace

std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log) {
  Orientations orientations = find_orientations(work, log.policy());
  const std::vector<char>& to_flip = orientations.to_flip;
  std::int64_t count = 0;
  std::int32_t first = -1;
  std::int32_t last = -1;
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    if (!to_flip[f]) continue;
    flip(work, static_cast<std::int32_t>(f));
    if (first < 0) first = work.origin[f];
    count += work.origin[f] != last;  // several triangles of one polygon count once
    last = work.origin[f];
  }
  for (std::int32_t& h : nonmanifold_edges.halfedges) {
    if (to_flip[h / 3]) h = 3 * (h / 3) + 2 - h % 3;
  }
  log.add(DefectKind::inconsistent_orientation, count, first,
          fmt::format("{} against the orientation of most of their component, first face {}",
                      counted(count, "face is", "faces are"), first),
          "flipped");
  return std::move(orientations.one_sided);
}

}  // namespace gvd
