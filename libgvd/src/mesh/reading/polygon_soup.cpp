// Makes a soup of arrays, and checks how many elements a mesh has.
#include "gvd/polygon_soup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/error.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {

void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name) {
  if (std::max(vertices, polygons) <= kMostVertices) return;
  throw Error(ErrorCode::precondition,
              fmt::format("{}: {} vertices and {} faces are more than 32-bit ids can count ({}); simplify the mesh",
                          name, vertices, polygons, kMostVertices));
}

PolygonSoup make_soup(std::span<const double> coordinates, std::span<const std::int64_t> corners, std::size_t size) {
  PolygonSoup soup;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    soup.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  for (const std::int64_t v : corners) {
    if (v < 0 || v >= std::ssize(soup.positions)) {
      const auto face = std::int64_t(soup.polygon_count());
      throw Error(
          ErrorCode::precondition,
          fmt::format("face {} has the vertex {}; there are {}, numbered from 0", face, v, soup.positions.size()),
          face);
    }
    soup.corners.push_back(std::int32_t(v));
    if (soup.corners.size() % size == 0) soup.close_polygon();
  }
  return soup;
}

}  // namespace gvd
