#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A triangle of a cut mesh.
struct CutTriangle {
  std::array<VertexId, 3> corners;
  FaceId parent;
  GeneratorId label = {};
  std::int32_t polygon = 0;  ///< the polygon that contains the triangle, numbered over all parents
  bool operator==(const CutTriangle&) const = default;
};

/// The triangles of a cut mesh before it is built. The triangles of a parent are consecutive, and so are the triangles
/// of a polygon.
struct CutTriangles {
  std::vector<Vec3> positions;
  std::vector<CutTriangle> triangles;
};

/// Calls visit(triangles) for each parent, with the span of its triangles.
template <class Visit>
void for_each_parent(std::span<const CutTriangle> all, Visit visit) {
  while (!all.empty()) {
    const auto is_other = [parent = all[0].parent](const CutTriangle& t) { return t.parent != parent; };
    const std::size_t count = std::ranges::find_if(all, is_other) - all.begin();
    visit(all.first(count));
    all = all.subspan(count);
  }
}

/// Splits each edge inside a parent at its midpoint if another edge joins the same two vertices: inside another parent,
/// on the border of a parent, or inside another polygon. Each split adds one vertex, and two triangles after the
/// parent's other triangles. Cost: O(k log k) for k triangles in cut parents, and O(n) in all.
void split_doubled_edges(CutTriangles& cut);

/// Moves apart the corners of triangles that have the same position, by a small multiple of `tolerance` (mesh units;
/// see `position_tolerance`).
///
/// In a face without area, points on two sides can have the same position although they are different vertices.
/// Vertices from `first_added` on may move along the longest edge of their parent; vertices of the input do not move.
/// Returns the number of rounds that moved a vertex; after kMaxSeparationRounds, corners may still coincide. Cost: O(k)
/// for k triangles in each of a few rounds.
int separate_coincident_corners(CutTriangles& cut, std::size_t first_added, double tolerance);

/// Each round moves vertices twice as far as the previous round, and separates vertices that the previous round moved
/// onto each other or onto a third vertex. The last round moves by 2^19 times the tolerance, 5e-10 of the largest
/// coordinate; a longer move would change the shape.
inline constexpr int kMaxSeparationRounds = 20;

}  // namespace gvd
