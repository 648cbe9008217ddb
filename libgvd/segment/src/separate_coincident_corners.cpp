#include "separate_coincident_corners.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// Direction of the longest edge of the triangles first to last, a unit vector; zero if all have length zero.
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

bool coincide(const CutTriangles& cut, VertexId a, VertexId b) {
  return cut.positions[a.index()] == cut.positions[b.index()];
}

/// Moves one of two coincident corners of triangle t. False if there are none, or none that may move.
bool separate_corners(CutTriangles& cut, std::size_t t, std::size_t first_added, const Vec3& shift) {
  const auto& corners = cut.faces[t];
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId later = std::max(corners[i], corners[(i + 1) % 3]);
    if (later.index() < first_added || !coincide(cut, corners[i], corners[(i + 1) % 3])) continue;
    Vec3& position = cut.positions[later.index()];
    const Vec3 before = position;
    position += shift;
    return position != before;  // the shift is 0 if all corners of the parent coincide
  }
  return false;
}

/// One round over the triangles first to last of one parent. True if a vertex moved.
bool separate_within(CutTriangles& cut, std::size_t first, std::size_t last, std::size_t first_added,
                     double tolerance) {
  const Vec3 shift = tolerance * longest_direction(cut, first, last);
  bool moved = false;
  for (std::size_t t = first; t < last; ++t) moved |= separate_corners(cut, t, first_added, shift);
  return moved;
}

}  // namespace

int separate_coincident_corners(CutTriangles& cut, std::size_t first_added, double tolerance) {
  for (int round = 0; round < kMaxSeparationRounds; ++round, tolerance *= 2) {
    bool moved = false;
    for (std::size_t first = 0, last = 0; first < cut.faces.size(); first = last) {
      last = end_of_parent(cut, first);
      const bool is_cut = last - first > 1;
      if (is_cut) moved |= separate_within(cut, first, last, first_added, tolerance);
    }
    if (!moved) return round;
  }
  return kMaxSeparationRounds;
}

}  // namespace gvd
