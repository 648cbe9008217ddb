#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// A position and its vertex, for sorting vertices by position and then by number.
using PlacedVertex = std::pair<std::array<double, 3>, std::int32_t>;

/// For each vertex, whether it is a corner of a polygon. Skips corners that refer to no vertex, which `build_mesh`
/// refuses. Cost: O(n).
std::vector<char> find_used_vertices(const PolygonSoup& soup);

/// Welds vertices at the same position: in an STL or after `weld_soup` all vertices of polygons, otherwise only
/// vertices that a polygon edge joins.
/// Returns per input vertex the vertex that replaces it: itself, or an earlier one at the same position.
/// Cost: O(n log n) for an STL, else O(n).
std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log);

/// Removes repeated corners from every polygon, and drops polygons with fewer than three remaining corners. `weld` is
/// the table of `weld_vertices`. Throws Error{precondition} if no polygon remains. Cost: O(n).
WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log);

/// Drops polygons with the same corners as an earlier polygon, in either direction. Keeps two faces back to back that
/// touch no other face, because they are a closed surface. Cost: O(n) if degrees are bounded, O(n log n) at worst.
void remove_duplicate_faces(WorkPolygons& polygons, std::size_t vertex_count, DefectLog& log);

}  // namespace gvd
