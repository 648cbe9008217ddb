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

/// Polygons as a file gives them. How they are connected is not known.
struct PolygonSoup {
  std::vector<Vec3> positions;               ///< mesh units
  std::vector<std::int32_t> corners;         ///< of all polygons, one after the other: indices into `positions`
  std::vector<std::size_t> first_corner{0};  ///< per polygon, and the number of corners at the end
  bool unwelded = false;                     ///< whether polygons may have vertices of their own (STL, GLB)
  std::optional<double> weld_tolerance;      ///< of `weld_soup`, in mesh units; nothing where nobody asked for it
  Appearance appearance;                     ///< of the polygons: texture coordinates and materials
  std::vector<std::string> notes;            ///< what the reader left out, one line each

  /// Makes a polygon of the corners that were appended last.
  void close_polygon() { first_corner.push_back(corners.size()); }
  std::size_t polygon_count() const { return first_corner.size() - 1; }
  std::span<const std::int32_t> polygon(std::size_t p) const {
    return {corners.data() + first_corner[p], first_corner[p + 1] - first_corner[p]};
  }
};

/// The soup of two arrays: three coordinates for each vertex, in mesh units, and `size` corners for each polygon.
/// Throws Error{precondition} for a corner that is no vertex. Cost: O(n).
PolygonSoup make_soup(std::span<const double> coordinates, std::span<const std::int64_t> corners, std::size_t size = 3);

/// A number for each vertex, or for each polygon, of a file.
struct SoupProperty {
  bool of_vertices = true;  ///< otherwise of polygons
  std::vector<double> values;
};

enum class SoupElement { vertex, polygon };

}  // namespace gvd
