#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// A position and its vertex, to sort vertices by their positions, then by their numbers.
using PlacedVertex = std::pair<std::array<double, 3>, std::int32_t>;

/// Per vertex whether it is a corner of a polygon. Corners that are no vertices, which `build_mesh` refuses, are
/// skipped. Cost: O(n).
std::vector<char> find_used_vertices(const PolygonSoup& soup);

/// Welds vertices at one position: all that polygons have in an STL or after `weld_soup`, elsewhere those that a
/// polygon edge joins.
/// Returns per input vertex the vertex that replaces it: itself, or an earlier one at the same position.
/// Cost: O(n log n) for an STL, else O(n).
std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log);

/// Takes repeated corners out of every polygon and drops polygons of fewer than three corners. `weld` is the table of
/// `weld_vertices`. Throws Error{precondition} where no polygon is left. Cost: O(n).
WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log);

/// Drops polygons with the corners of an earlier one, in either direction. Two faces back to back that no other face
/// touches stay: they are a closed surface. Cost: O(n) where degrees are bounded, O(n log n) at worst.
void remove_duplicate_faces(WorkPolygons& polygons, std::size_t vertex_count, DefectLog& log);

}  // namespace gvd
