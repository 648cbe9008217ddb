#include "io/view/view_triangulate.hpp"

#include <cstddef>

#include "base/ear_clipping.hpp"
#include "base/plane.hpp"

namespace gvd::io {
namespace {

/// Largest doubled area, in barycentric coordinates, of a triangle that is left out. It is 1e-14 of the face's doubled
/// area, a hundred times the rounding error of products of coordinates in [0, 1].
constexpr double kShareLeftOut = 1e-14;

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec2>& corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& [a, b, c] : triangulate_plane_polygon(corners)) {
    if (cross(corners[b] - corners[a], corners[c] - corners[a]) <= kShareLeftOut) continue;
    triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  }
  return triangles;
}

}  // namespace gvd::io
