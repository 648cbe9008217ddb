#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/vec.hpp"
#include "mesh/visit_edges.hpp"

namespace gvd {

/// Triangles while they are oriented and cut. Halfedge 3 f + i runs from corner i of face f to the next corner.
struct WorkFaces {
  std::vector<std::array<std::int32_t, 3>> faces;  ///< vertices of the soup, until `cut_vertices` appends copies
  std::vector<std::int32_t> origin;                ///< per face, its polygon in the soup
  std::vector<std::int32_t> twin;                  ///< per halfedge, -1 where there is none
  std::vector<std::int32_t> source;  ///< after `cut_vertices`: per vertex, its vertex in the soup, -1 for a midpoint
  std::vector<Vec3> positions;       ///< after `cut_vertices`: per vertex, in mesh units

  std::int32_t from(std::int32_t h) const { return faces[h / 3][h % 3]; }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t halfedge_count() const { return static_cast<std::int32_t>(3 * faces.size()); }
};

/// As `visit_edges` of a list of triangles.
template <class Visit>
void visit_edges(const WorkFaces& work, std::size_t vertex_count, const Visit& visit) {
  visit_edges(
      work.faces, vertex_count, [](std::int32_t v) { return static_cast<std::uint64_t>(v); }, visit);
}

}  // namespace gvd
