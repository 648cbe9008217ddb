#include "part_coincident_corners.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// The longest edge among the triangles first to last, as a unit vector; zero where all have no length.
Vec3 longest_direction(const CutTriangles& cut, std::size_t first, std::size_t last) {
  Vec3 longest = Vec3::Zero();
  for (std::size_t t = first; t < last; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 edge = cut.positions[cut.faces[t][(i + 1) % 3].index()] - cut.positions[cut.faces[t][i].index()];
      if (edge.norm() > longest.norm()) longest = edge;
    }
  }
  return longest.stableNormalized();
}

bool have_one_place(const CutTriangles& cut, VertexId a, VertexId b) {
  return cut.positions[a.index()] == cut.positions[b.index()];
}

/// Moves one of two corners of triangle t that are in one place. False where there are none that may be moved.
bool part_corners(CutTriangles& cut, std::size_t t, std::size_t first_added, const Vec3& shift) {
  const auto& corners = cut.faces[t];
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId later = std::max(corners[i], corners[(i + 1) % 3]);
    if (later.index() < first_added || !have_one_place(cut, corners[i], corners[(i + 1) % 3])) continue;
    Vec3& place = cut.positions[later.index()];
    const Vec3 before = place;
    place += shift;
    return place != before;  // the shift is 0 where all of the parent is in one place
  }
  return false;
}

/// One round over the triangles first to last, those of one parent. True where a vertex was moved.
bool part_within(CutTriangles& cut, std::size_t first, std::size_t last, std::size_t first_added, double reach) {
  const Vec3 shift = reach * longest_direction(cut, first, last);
  bool moved = false;
  for (std::size_t t = first; t < last; ++t) moved |= part_corners(cut, t, first_added, shift);
  return moved;
}

}  // namespace

int part_coincident_corners(CutTriangles& cut, std::size_t first_added, double reach) {
  for (int round = 0; round < kPartingRounds; ++round, reach *= 2) {
    bool moved = false;
    for (std::size_t first = 0, last = 0; first < cut.faces.size(); first = last) {
      last = end_of_parent(cut, first);
      const bool is_cut = last - first > 1;
      if (is_cut) moved |= part_within(cut, first, last, first_added, reach);
    }
    if (!moved) return round;
  }
  return kPartingRounds;
}

}  // namespace gvd
