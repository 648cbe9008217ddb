#pragma once

namespace gvd {

// The lattice of a triangle whose sides are cut into k equal parts: at point (i, j), with i + j <= k, two of the
// corners have the weights i / k and j / k. The lattice cuts the triangle into k * k congruent triangles.

/// Calls visit(i, j) for each point, in the order of i, then of j.
template <class Visit>
void for_each_lattice_point(int k, const Visit& visit) {
  for (int i = 0; i <= k; ++i) {
    for (int j = 0; i + j <= k; ++j) visit(i, j);
  }
}

/// The number of a point in that order.
constexpr int lattice_number(int k, int i, int j) { return i * (2 * k + 3 - i) / 2 + j; }

/// Calls visit(i, j, is_upright) for each triangle, in the order of i, then of j. The upright triangle at (i, j) has
/// the points (i, j), (i + 1, j) and (i, j + 1). The inverted triangle at (i, j) lies beyond the side of the last two:
/// it has the points (i + 1, j + 1), (i, j + 1) and (i + 1, j).
template <class Visit>
void for_each_lattice_triangle(int k, const Visit& visit) {
  for (int i = 0; i < k; ++i) {
    for (int j = 0; i + j < k; ++j) {
      visit(i, j, true);
      if (i + j + 1 < k) visit(i, j, false);
    }
  }
}

}  // namespace gvd
