#include "mesh/repair/examine_soup.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mesh/repair/defect_log.hpp"

namespace gvd {
namespace {

void examine_positions(const PolygonSoup& soup) {
  if (soup.positions.empty()) refuse_soup("the soup has no vertices", -1);
  Vec3 low = soup.positions.front();
  Vec3 high = low;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const Vec3& p = soup.positions[v];
    const auto element = static_cast<std::int64_t>(v);
    if (!p.allFinite()) refuse_soup(fmt::format("vertex {} has a coordinate that is not finite", v), element);
    if (p.cwiseAbs().maxCoeff() > kLargestCoordinate) {
      refuse_soup(fmt::format("vertex {} has a coordinate beyond {:g}; scale the mesh down", v, kLargestCoordinate),
                  element);
    }
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  if (extent == 0) refuse_soup("all vertices are at one position, that of vertex 0: there is no surface", 0);
  if (extent < kSmallestExtent) {
    refuse_soup(fmt::format("the whole mesh is smaller than {:g}; scale it up", kSmallestExtent), 0);
  }
}

void examine_polygons(const PolygonSoup& soup) {
  if (soup.first_corner.empty() || soup.first_corner.front() != 0 || soup.first_corner.back() != soup.corners.size()) {
    refuse_soup("the soup's first_corner does not span its corners", -1);
  }
  if (soup.polygon_count() == 0) refuse_soup("the soup has no face", -1);
  constexpr std::size_t kMost = 0x7fffffff;
  if (soup.positions.size() > kMost || soup.polygon_count() > kMost) {
    refuse_soup("the soup has more elements than 32-bit ids can count", -1);
  }
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    const auto element = static_cast<std::int64_t>(p);
    if (soup.first_corner[p] > soup.first_corner[p + 1] || soup.first_corner[p + 1] > soup.corners.size()) {
      refuse_soup(fmt::format("the soup's first_corner is out of order at face {}", p), element);
    }
    for (std::size_t c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      const std::int32_t v = soup.corners[c];
      if (v < 0 || static_cast<std::size_t>(v) >= soup.positions.size()) {
        refuse_soup(fmt::format("face {} refers to vertex {}, and there are {}", p, v, soup.positions.size()), element);
      }
    }
  }
}

}  // namespace

void examine_soup(const PolygonSoup& soup) {
  examine_polygons(soup);
  examine_positions(soup);
}

}  // namespace gvd
