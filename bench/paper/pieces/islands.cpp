#include "pieces/islands.hpp"

#include <algorithm>

#include "base/barycentric.hpp"
#include "base/union_find.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::paper {
namespace {

/// A point this far outside of a piece counts as inside, in barycentric coordinates: a thousand times the rounding.
constexpr double kInside = 1e-9;

/// Whether a point lies in a polygon that need not be convex, or near its border.
bool contains(const FacePiece& piece, const Bary& bary) {
  const std::size_t n = piece.corners.size();
  const Vec2 p = affine_point(bary);
  bool inside = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = affine_point(piece.corners[i]) - p, b = affine_point(piece.corners[(i + 1) % n]) - p;
    const double along = std::clamp(-a.dot(b - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
    if ((a + along * (b - a)).norm() <= kInside) return true;
    if ((a.y() > 0) != (b.y() > 0) && (cross(a, b) > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

/// Calls visit(index) for every piece of the generator's label that contains it.
template <class Visit>
void for_each_own_piece(const Mesh& mesh, const Pieces& pieces, GeneratorId g, const SurfacePoint& point, Visit visit) {
  for (const SurfacePoint& view : find_views(mesh, point)) {
    auto it =
        std::partition_point(pieces.begin(), pieces.end(), [&](const FacePiece& p) { return p.face < view.face; });
    for (; it != pieces.end() && it->face == view.face; ++it) {
      if (it->generator == g && contains(*it, view.bary)) visit(static_cast<std::size_t>(it - pieces.begin()));
    }
  }
}

CellParts number_parts(const Mesh& mesh, const Pieces& pieces, UnionFind& sets) {
  CellParts parts;
  parts.part_of.resize(pieces.size(), -1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(i)));
    if (parts.part_of[root] < 0) {
      parts.part_of[root] = static_cast<std::int32_t>(parts.area.size());
      parts.generator.push_back(pieces[root].generator);
      parts.area.push_back(0);
    }
    parts.part_of[i] = parts.part_of[root];
    const double area = mesh.area(pieces[i].face) * area_share(pieces[i].corners);
    parts.area[parts.part_of[i]] += area;
    parts.total_area += area;
  }
  parts.has_generator.resize(parts.area.size(), 0);
  return parts;
}

}  // namespace

CellParts find_cell_parts(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Pieces& pieces,
                          const std::vector<Contact>& contacts) {
  UnionFind sets(pieces.size());
  const auto label = [&](std::int32_t i) { return pieces[i].generator; };
  for (const Contact& c : contacts) {
    if (label(c.left) == label(c.right)) sets.unite(c.left, c.right);
  }
  CellParts parts = number_parts(mesh, pieces, sets);
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const GeneratorId g(i);
    for_each_own_piece(mesh, pieces, g, generators[i],
                       [&](std::size_t piece) { parts.has_generator[parts.part_of[piece]] = 1; });
  }
  return parts;
}

}  // namespace gvd::paper
