// A point opposite the generator of a cell that goes round a limb, so that the two share the way round.
//
// Let g be the generator, a and b points on two borders of its cell, and P a shortest path from a to b in the cell, of
// length D. A point p of P that is at s from a along P, with
//   s < d(a, g)  and  D - s < d(b, g),
// has all of P in its cell rather than in that of g: if x between a and p were nearer to g than to p, then so would be
// a, since d(a, g) <= d(a, x) + d(x, g) < d(a, x) + d(x, p) <= s. The new cell of g lies in the old one without P. For
// an annulus that is a disc; and the new cell of g has no hole, because that of p is connected and reaches the border.
// Such an s exists if D < d(a, g) + d(b, g), that is, if no shortest path from a to b passes through g.
//
// The cell of p is a disc, too, unless p shuts g out in turn. On a tube of half girth l, at r_a and r_b from its ends,
// p may be l^2 / 2r farther along than g, which is little on a long tube. It can be much less than an edge, so p is
// placed by the lengths of shortest paths: (s - d(a, g)) d(a, g) = (D - s - d(b, g)) d(b, g) puts p as far along a tube
// as g, within terms of the fourth order in l, and satisfies both conditions on any surface.
//
// P is sought in the faces that meet the cell. It may leave a cell that has handles, and then nothing is proved, so the
// caller has to try the point.
//
// The best point of a border is the one behind the generator, where the direction in which shortest paths leave the
// generator jumps most, from one way around to the other.

#include <algorithm>
#include <cmath>

#include "base/least.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/exact_field.hpp"
#include "repair/cell_topology.hpp"
#include "repair/local_dual.hpp"

namespace gvd {
namespace {

/// A cell with many borders, as around many holes, gets one point after the other, because each takes two exact fields.
constexpr std::size_t kMostPoints = 4;

/// A point of a border of the cell, in the part of the mesh that meets the cell.
struct BorderPoint {
  SurfacePoint point;
  double distance = 0;  ///< from the generator, mesh units
};

/// The angle between two directions, from 0 to pi.
double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// The point of a border behind the generator of the field; nothing where no path leads to the border.
std::optional<BorderPoint> find_behind(const Submesh& part, const ExactField& field,
                                       const std::vector<SurfacePoint>& border) {
  std::vector<BorderPoint> points;
  std::vector<Vec2> directions;
  for (const SurfacePoint& of_whole : border) {
    const auto point = part.to_part(of_whole);
    if (!point) continue;
    const GeodesicPath path = field.path(*point);
    if (!path.complete || !(path.length > 0)) continue;
    points.push_back({*point, path.length});
    directions.push_back(field.departure(path));
  }
  Least<std::optional<BorderPoint>> best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    const BorderPoint& farther = points[i].distance < points[next].distance ? points[next] : points[i];
    best.offer(-angle_between(directions[i], directions[next]), farther);
  }
  return best.value;
}

/// The point at a distance along a path from its end.
SurfacePoint point_before_end(const Mesh& mesh, const std::vector<SurfacePoint>& path, double from_end) {
  for (std::size_t i = path.size() - 1; i > 0; --i) {
    const Vec3 at = position(mesh, path[i]), step = position(mesh, path[i - 1]) - at;
    const double length = step.norm();
    if (from_end > length) {
      from_end -= length;
    } else if (const auto view = find_common_view(mesh, path[i], path[i - 1]); view && length > 0) {
      return closest_point_on_face(mesh, view->first.face, at + from_end / length * step).point;
    }
  }
  return path.front();
}

/// The point on the shortest path between two points of borders that is as far along as the generator.
std::optional<SurfacePoint> find_opposite(const Mesh& mesh, const BorderPoint& a, const BorderPoint& b) {
  const GeodesicPath path = ExactField(mesh, {a.point}, {.threads = 1}).path(b.point);
  if (!path.complete || !(path.length < a.distance + b.distance)) return std::nullopt;
  const double s = a.distance - b.distance + path.length * b.distance / (a.distance + b.distance);
  return point_before_end(mesh, path.points, std::clamp(s, 0.0, path.length));
}

}  // namespace

std::vector<SurfacePoint> find_opposite_points(const Mesh& mesh, const Diagram& diagram, GeneratorId cell,
                                               const std::vector<std::vector<SurfacePoint>>& borders) {
  if (borders.size() < 2) return {};
  CellFlags in_part(diagram.generators.size(), 0);
  in_part[cell] = 1;
  const CellPart part = cut_out_cells(mesh, diagram, in_part);
  const auto generator = part.to_part(diagram.generators[cell.index()]);
  if (!generator) return {};
  const ExactField field(part.mesh, {*generator}, {.threads = 1});
  std::vector<SurfacePoint> points;
  std::optional<BorderPoint> last;
  for (const std::vector<SurfacePoint>& border : borders) {
    const auto behind = find_behind(part, field, border);
    if (!behind) continue;
    if (last) {
      if (const auto point = find_opposite(part.mesh, *last, *behind)) points.push_back(part.to_whole(*point));
    }
    if (points.size() == kMostPoints) break;
    last = behind;
  }
  return points;
}

}  // namespace gvd
