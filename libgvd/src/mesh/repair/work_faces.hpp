#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// The polygons of a soup while they are cleaned. Corners are vertices of the soup.
struct WorkPolygons {
  std::vector<std::int32_t> corners;         ///< of all polygons, one after the other
  std::vector<std::size_t> first_corner{0};  ///< per polygon, followed by the number of all corners
  std::vector<std::int32_t> origin;          ///< for each polygon, its number in the soup

  std::size_t count() const { return origin.size(); }
  std::span<const std::int32_t> polygon(std::size_t p) const {
    return {corners.data() + first_corner[p], first_corner[p + 1] - first_corner[p]};
  }
  /// Makes a polygon of the corners appended since the last one; `from` is its number in the soup.
  void close(std::int32_t from) {
    first_corner.push_back(corners.size());
    origin.push_back(from);
  }
};

/// Triangles while they are oriented and cut. Halfedge 3 f + i runs from corner i of face f to the next corner.
struct WorkFaces {
  std::vector<std::array<std::int32_t, 3>> faces;  ///< vertices of the soup, until `cut_vertices` appends copies
  std::vector<std::int32_t> origin;                ///< for each face, its polygon in the soup
  std::vector<std::int32_t> twin;                  ///< for each halfedge; -1 if there is none
  std::vector<std::int32_t> source;  ///< after `cut_vertices`: per vertex, its vertex in the soup, -1 for a midpoint
  std::vector<Vec3> positions;       ///< after `cut_vertices`: per vertex, in mesh units

  std::int32_t from(std::int32_t h) const { return faces[h / 3][h % 3]; }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t face_count() const { return static_cast<std::int32_t>(faces.size()); }
  std::int32_t halfedge_count() const { return 3 * face_count(); }
  /// Makes two halfedges each other's twins.
  void link(std::int32_t a, std::int32_t b) {
    twin[a] = b;
    twin[b] = a;
  }
};

/// Edges of three or more faces: for each edge its halfedges of either direction, ascending.
using EdgeTable = std::vector<std::vector<std::int32_t>>;

/// Sets `twin` for the two halfedges of each edge with two faces, whatever their directions. Returns the edges of three
/// or more faces, in the order of `visit_edges`. Cost: as for `visit_edges`.
EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count);

}  // namespace gvd
