#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gvd {

/// The polygons of a soup while they are cleaned. Corners are vertices of the soup.
struct WorkPolygons {
  std::vector<std::int32_t> corners;         ///< of all polygons, one after the other
  std::vector<std::size_t> first_corner{0};  ///< per polygon, and the number of corners at the end
  std::vector<std::int32_t> origin;          ///< per polygon, its polygon in the soup

  std::size_t count() const { return origin.size(); }
  std::span<const std::int32_t> polygon(std::size_t p) const {
    return {corners.data() + first_corner[p], first_corner[p + 1] - first_corner[p]};
  }
  /// Makes a polygon of the corners that were appended last; `from` is its polygon in the soup.
  void close(std::int32_t from) {
    first_corner.push_back(corners.size());
    origin.push_back(from);
  }
};

}  // namespace gvd
