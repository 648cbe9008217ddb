#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Polygons as a file gives them. Their connectivity is not known yet.
struct PolygonSoup {
  std::vector<Vec3> positions;               ///< mesh units
  std::vector<std::int32_t> corners;         ///< indices into `positions`, polygon by polygon
  std::vector<std::size_t> first_corner{0};  ///< first corner of each polygon, and the number of corners at the end
  bool unwelded = false;                     ///< whether polygons may have vertices of their own (STL, GLB)
  std::optional<double> weld_tolerance;      ///< tolerance of `weld_soup`, mesh units; nothing if it was not called
  Appearance appearance;                     ///< texture coordinates and materials of the polygons
  std::vector<std::string> notes;            ///< what the reader left out, one line each

  /// Makes a polygon of the corners that were appended to `corners` since the last polygon.
  void close_polygon() { first_corner.push_back(corners.size()); }
  std::size_t polygon_count() const { return first_corner.size() - 1; }
  std::span<const std::int32_t> polygon(std::size_t p) const {
    return {corners.data() + first_corner[p], first_corner[p + 1] - first_corner[p]};
  }
};

/// Makes a soup from two arrays: three coordinates for each vertex, in mesh units, and `size` corners for each polygon.
/// Throws Error{precondition} for a corner that is no vertex. Cost: O(n).
PolygonSoup make_soup(std::span<const double> coordinates, std::span<const std::int64_t> corners, std::size_t size = 3);

/// One number for each vertex, or for each polygon, of a file.
struct SoupProperty {
  bool of_vertices = true;  ///< if false, of polygons
  std::vector<double> values;
};

enum class SoupElement { vertex, polygon };

}  // namespace gvd
