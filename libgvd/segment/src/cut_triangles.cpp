// Repairs the triangles of a cut mesh before the mesh is built.
//
// Two edges with the same ends arise in two ways: two parents with the same three corners are cut between the same
// points of their sides, or two polygons on both sides of a bisector, whose points rounding has made collinear, have
// the same diagonal. In both cases an edge lies inside a parent, so a vertex at its midpoint affects only two
// triangles.
// Corners coincide if rounding has put an added vertex onto another vertex. The added vertex is moved by a few units in
// the last place; vertices of the input never move.
#include "cut_triangles.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace gvd {
namespace {

/// Marks a side that lies between two polygons.
constexpr std::int32_t kBetween = -1;

/// A side of a triangle, with its ends in ascending order.
struct Side {
  VertexId low;
  VertexId high;
  FaceId parent;
  std::int32_t polygon;
  auto operator<=>(const Side&) const = default;
  bool joins_same(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> collect_sides_of_cut_parents(const CutTriangles& cut) {
  std::vector<Side> sides;
  for_each_parent(cut.triangles, [&](std::span<const CutTriangle> triangles) {
    if (triangles.size() == 1) return;
    for (const CutTriangle& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(t.corners[i], t.corners[(i + 1) % 3]);
        sides.push_back({low, high, t.parent, t.polygon});
      }
    }
  });
  return sides;
}

/// Given sides with the same ends, appends the edges that lie inside parents: diagonals of polygons, and edges between
/// two polygons.
void append_inner_edges(std::span<const Side> sides, std::vector<Side>& edges) {
  const Side* single = nullptr;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    if (i + 1 < sides.size() && sides[i + 1] == side) {
      edges.push_back(side);
      ++i;
    } else if (single && single->parent == side.parent) {
      edges.push_back({side.low, side.high, side.parent, kBetween});
      single = nullptr;
    } else {
      single = &side;
    }
  }
}

/// Finds the edges inside parents whose two ends are joined by sides of more than two triangles, sorted by parent. A
/// diagonal comes before an edge between two polygons with the same ends.
std::vector<Side> find_doubled_edges(const CutTriangles& cut) {
  std::vector<Side> sides = collect_sides_of_cut_parents(cut), doubled;
  std::sort(sides.begin(), sides.end());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].joins_same(sides[first])) ++last;
    if (last - first > 2) append_inner_edges(std::span(sides).subspan(first, last - first), doubled);
  }
  std::sort(doubled.begin(), doubled.end(), [](const Side& a, const Side& b) {
    return std::tie(a.parent, a.low, a.high, b.polygon) < std::tie(b.parent, b.low, b.high, a.polygon);
  });
  return doubled;
}

/// Halves the triangles from `begin` on that have the edge as a side. If the edge is a diagonal, halves only triangles
/// of its polygon.
void split_edge(const Side& edge, std::size_t begin, CutTriangles& cut) {
  const VertexId middle(cut.positions.size());
  cut.positions.push_back(0.5 * (cut.positions[edge.low.index()] + cut.positions[edge.high.index()]));
  const std::size_t end = cut.triangles.size();
  for (std::size_t t = begin; t < end; ++t) {
    const CutTriangle whole = cut.triangles[t];
    if (edge.polygon != kBetween && edge.polygon != whole.polygon) continue;
    for (int i = 0; i < 3; ++i) {
      const VertexId from = whole.corners[i], to = whole.corners[(i + 1) % 3], apex = whole.corners[(i + 2) % 3];
      if (std::min(from, to) != edge.low || std::max(from, to) != edge.high) continue;
      cut.triangles[t].corners = {from, middle, apex};
      cut.triangles.push_back({{middle, to, apex}, whole.parent, whole.label, whole.polygon});
      break;
    }
  }
}

/// The direction of the longest edge of the triangles, as a unit vector; zero if all edges have length zero.
Vec3 longest_direction(std::span<const CutTriangle> triangles, const std::vector<Vec3>& positions) {
  Vec3 longest = Vec3::Zero();
  for (const CutTriangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 edge = positions[t.corners[(i + 1) % 3].index()] - positions[t.corners[i].index()];
      if (edge.norm() > longest.norm()) longest = edge;
    }
  }
  return longest.stableNormalized();
}

/// Moves one of two coincident corners of a triangle. Returns false if no corners coincide, or if none of them may
/// move.
bool separate_corners(const CutTriangle& t, std::size_t first_added, const Vec3& shift, std::vector<Vec3>& positions) {
  for (int i = 0; i < 3; ++i) {
    const auto [earlier, later] = std::minmax(t.corners[i], t.corners[(i + 1) % 3]);
    if (later.index() < first_added || positions[earlier.index()] != positions[later.index()]) continue;
    Vec3& position = positions[later.index()];
    const Vec3 before = position;
    position += shift;
    return position != before;  // the shift is 0 if all corners of the parent coincide
  }
  return false;
}

}  // namespace

void split_doubled_edges(CutTriangles& cut) {
  const std::vector<Side> doubled = find_doubled_edges(cut);
  if (doubled.empty()) return;
  auto next = doubled.begin();
  const std::vector<CutTriangle> before = std::exchange(cut.triangles, {});
  for_each_parent(before, [&](std::span<const CutTriangle> triangles) {
    const std::size_t begin = cut.triangles.size();
    cut.triangles.insert(cut.triangles.end(), triangles.begin(), triangles.end());
    for (; next != doubled.end() && next->parent == triangles[0].parent; ++next) split_edge(*next, begin, cut);
  });
}

int separate_coincident_corners(CutTriangles& cut, std::size_t first_added, double tolerance) {
  for (int round = 0; round < kMaxSeparationRounds; ++round, tolerance *= 2) {
    bool moved = false;
    for_each_parent(cut.triangles, [&](std::span<const CutTriangle> triangles) {
      if (triangles.size() == 1) return;
      const Vec3 shift = tolerance * longest_direction(triangles, cut.positions);
      for (const CutTriangle& t : triangles) moved |= separate_corners(t, first_added, shift, cut.positions);
    });
    if (!moved) return round;
  }
  return kMaxSeparationRounds;
}

}  // namespace gvd
