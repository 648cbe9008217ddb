#pragma once

namespace gvd {

// The lattice of a triangle whose sides are cut into k parts: point (i, j), with i + j <= k, has the weights i / k and
// j / k of two corners. It cuts the triangle into k * k equal ones.

/// Calls visit(i, j) for each point, by i, then by j.
template <class Visit>
void for_each_lattice_point(int k, const Visit& visit) {
  for (int i = 0; i <= k; ++i) {
    for (int j = 0; i + j <= k; ++j) visit(i, j);
  }
}

/// The number of a point in that order.
constexpr int lattice_number(int k, int i, int j) { return i * (2 * k + 3 - i) / 2 + j; }

/// Calls visit(i, j, is_upright) for each of the triangles, by i, then by j. An upright one has the points (i, j),
/// (i + 1, j) and (i, j + 1); the other one at (i, j) is beyond it: (i + 1, j + 1), (i, j + 1) and (i + 1, j).
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
