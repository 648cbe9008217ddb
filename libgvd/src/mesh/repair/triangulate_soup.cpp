// The polygons of a soup become triangles, where possible along diagonals that are not edges yet.
//
// A second edge between two vertices of the mesh would count as the same edge, with four faces. So a diagonal that is
// an edge already is the last choice. Quadrilaterals, the most frequent polygons, are cut along the better diagonal;
// larger polygons by clipping ears.
// Invariant: each triangle but the last of its polygon was cut off along the side from its third corner to its first.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_set>

#include "gvd/text.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "mesh/repair/triangulate_soup_polygon.hpp"

namespace gvd {
namespace {

/// The second diagonal of a quadrilateral is taken only if it is better by more than this fraction. So rounding does
/// not decide between those of a square. Dimensionless; far above the rounding of a few operations.
constexpr double kBetterDiagonal = 1e-6;

std::uint64_t edge_key(std::int32_t a, std::int32_t b) {
  return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
}

/// The edges of all polygons, and the diagonals that were added. Only membership is asked, so that the order of the
/// hash set does not reach the output.
class KnownEdges {
 public:
  explicit KnownEdges(const WorkPolygons& polygons) {
    edges_.reserve(polygons.corners.size());
    for (std::size_t p = 0; p < polygons.count(); ++p) {
      const auto polygon = polygons.polygon(p);
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        edges_.push_back(edge_key(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1]));
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  bool contains(std::int32_t a, std::int32_t b) const {
    const std::uint64_t key = edge_key(a, b);
    return diagonals_.contains(key) || std::binary_search(edges_.begin(), edges_.end(), key);
  }
  void add_diagonal(std::int32_t a, std::int32_t b) { diagonals_.insert(edge_key(a, b)); }

 private:
  std::vector<std::uint64_t> edges_;
  std::unordered_set<std::uint64_t> diagonals_;
};

class Triangulator {
 public:
  Triangulator(const WorkPolygons& polygons, const std::vector<Vec3>& positions)
      : positions_(positions), known_(polygons), is_edge_([this](auto a, auto b) { return known_.contains(a, b); }) {}

  void add(std::span<const std::int32_t> polygon, std::int32_t origin, WorkFaces& work) {
    const std::size_t begin = work.faces.size();
    if (polygon.size() == 3) {
      work.faces.push_back({polygon[0], polygon[1], polygon[2]});
    } else if (polygon.size() != 4 || !split_quad(polygon, work.faces, Quad::simple)) {
      const PolygonShape shape = triangulate_polygon(polygon, positions_, is_edge_, work.faces);
      if (shape != PolygonShape::simple) cut_crossing_quad(shape, polygon, origin, work.faces);
    }
    work.origin.resize(work.faces.size(), origin);
    // Each triangle but the last was cut off along the side from its third corner to its first.
    for (std::size_t f = begin; f + 1 < work.faces.size(); ++f) known_.add_diagonal(work.faces[f][2], work.faces[f][0]);
  }

  /// The quadrilaterals that cross themselves, and the first of them.
  std::int64_t crossing_quads() const { return crossing_quads_; }
  std::int32_t first_crossing_quad() const { return first_crossing_quad_; }

 private:
  /// Whether the two triangles of a quadrilateral must face the same way.
  enum class Quad { simple, crossing };

  const Vec3& at(std::int32_t v) const { return positions_[v]; }

  /// Quality of the diagonal a-c: that of the worse of its two triangles, twice the area over the sum of the squared
  /// sides. 0 where a triangle is flat, the two of a simple quadrilateral face different ways, or the diagonal is an
  /// edge already.
  double diagonal_quality(const std::array<std::int32_t, 4>& quad, Quad shape) const {
    const auto [a, b, c, d] = quad;
    const Vec3 normal_b = (at(b) - at(a)).cross(at(c) - at(a));
    const Vec3 normal_d = (at(c) - at(a)).cross(at(d) - at(a));
    if ((shape == Quad::simple && !(normal_b.dot(normal_d) > 0)) || known_.contains(a, c)) return 0;
    const double diagonal = (at(c) - at(a)).squaredNorm();
    const double squares_b = diagonal + (at(b) - at(a)).squaredNorm() + (at(c) - at(b)).squaredNorm();
    const double squares_d = diagonal + (at(d) - at(a)).squaredNorm() + (at(c) - at(d)).squaredNorm();
    return std::min(normal_b.norm() / squares_b, normal_d.norm() / squares_d);
  }

  bool split_quad(std::span<const std::int32_t> q, std::vector<std::array<std::int32_t, 3>>& faces, Quad shape) const {
    const std::int32_t a = q[0], b = q[1], c = q[2], d = q[3];
    if (a == c || b == d) return false;
    const double first = diagonal_quality({a, b, c, d}, shape);
    const double second = diagonal_quality({b, c, d, a}, shape);
    if (std::max(first, second) == 0) return false;
    if (second > first * (1 + kBetterDiagonal)) {
      faces.push_back({d, a, b});
      faces.push_back({b, c, d});
    } else {
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
    return true;
  }

  /// Cuts a quadrilateral that crosses itself into two triangles with area, or refuses the polygon.
  void cut_crossing_quad(PolygonShape shape, std::span<const std::int32_t> polygon, std::int32_t origin,
                         std::vector<std::array<std::int32_t, 3>>& faces) {
    if (polygon.size() != 4 || !split_quad(polygon, faces, Quad::crossing)) refuse(shape, polygon.size(), origin);
    if (crossing_quads_++ == 0) first_crossing_quad_ = origin;
  }

  [[noreturn]] static void refuse(PolygonShape shape, std::size_t corners, std::int32_t origin) {
    if (shape == PolygonShape::too_complex) {
      refuse_soup(
          fmt::format("face {} has {} corners in too complex a shape; cut it into smaller ones", origin, corners),
          origin);
    }
    refuse_soup(fmt::format("face {} with its {} corners crosses itself; cut it into triangles", origin, corners),
                origin);
  }

  const std::vector<Vec3>& positions_;
  KnownEdges known_;
  EdgeQuery is_edge_;
  std::int64_t crossing_quads_ = 0;
  std::int32_t first_crossing_quad_ = -1;
};

}  // namespace

WorkFaces triangulate_polygons(WorkPolygons polygons, const std::vector<Vec3>& positions, DefectLog& log) {
  WorkFaces work;
  const std::size_t triangles = polygons.corners.size() - 2 * polygons.count();
  if (triangles > 0x7fffffff / 3) {
    refuse_soup(fmt::format("{} triangles are more than 32-bit ids can count", triangles), -1);
  }
  work.faces.reserve(triangles);
  if (polygons.corners.size() == 3 * polygons.count()) {
    for (std::size_t p = 0; p < polygons.count(); ++p) {
      const auto triangle = polygons.polygon(p);
      work.faces.push_back({triangle[0], triangle[1], triangle[2]});
    }
    work.origin = std::move(polygons.origin);
    return work;
  }
  work.origin.reserve(triangles);
  Triangulator triangulator(polygons, positions);
  for (std::size_t p = 0; p < polygons.count(); ++p) {
    triangulator.add(polygons.polygon(p), polygons.origin[p], work);
  }
  const std::int32_t first = triangulator.first_crossing_quad();
  log.add(DefectKind::crossing_quads, triangulator.crossing_quads(), first,
          fmt::format(
              "{}, first face {}",
              counted(triangulator.crossing_quads(), "quadrilateral crosses itself", "quadrilaterals cross themselves"),
              first),
          "cut along a diagonal");
  return work;
}

}  // namespace gvd
