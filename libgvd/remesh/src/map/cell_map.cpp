// The map of one cell: its disc in the plane on one side, a fan of triangles on the other.
//
// On the remesh the cell's border runs from polygon to polygon, straight from a centre to a crossing on an edge and on
// to the next centre. In the plane it is a star with nearly the shape of that part of the remesh, or a circle. The
// vertices of each straight piece are spaced by their distances on the surface, a little evened out so that none
// coincide. Both cells of a bisector compute the same numbers for it: the map fits together to the last bit. The disc
// holds the faces of the surface, the fan the cell's part of the remesh. They have the same border, so a point goes
// from the surface to the plane by its face, and from there to the remesh by its triangle of the fan. Shapes and
// weights are tried in turn, from the best looking to the safest, until no triangle of either side is turned over. The
// signs are certain, so a cell that passes is mapped one-to-one: docs/developer/proofs.md, section 7.

#include "map/cell_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/barycentric.hpp"
#include "base/least.hpp"
#include "base/plane.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "map/cut_into_cells.hpp"
#include "map/dual_polygons.hpp"

namespace gvd {

std::vector<double> lengths_along(const Mesh& mesh, const std::vector<VertexId>& path) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    lengths.push_back(lengths.back() + (mesh.position(path[i]) - mesh.position(path[i - 1])).norm());
  }
  return lengths;
}

namespace {

/// The weight of even spacing in the spacing of a path's vertices. It keeps nearly coincident vertices apart.
constexpr double kEvenShare = 0.01;

/// Numbers from 0 to 1 for the vertices of a path, ascending, by their distances.
std::vector<double> space(const Mesh& mesh, const std::vector<VertexId>& path, double even_share) {
  std::vector<double> at = lengths_along(mesh, path);
  scale_and_even(at, 1, even_share);
  return at;
}

using Path = std::vector<VertexId>;

/// A bisector crosses its edge between this parameter and 1 minus it. Nearer to an end, the crossing would squeeze the
/// triangles of one cell's fan.
constexpr double kLeastCrossing = 0.1;

/// The point where a bisector crosses the edge between the remesh's vertices of its cells.
struct BisectorCrossing {
  std::size_t number = 0;  ///< of the bisector's vertex
  double t = 0.5;          ///< on the edge, from the vertex of the cell with the smaller id
};

/// The vertex of a path that is nearest to the edge, the same from both sides: an end on the boundary, or an inner one.
BisectorCrossing find_crossing(const CellSurface& surface, const DualPolygons& polygons, const Path& path,
                               std::pair<GeneratorId, GeneratorId> cells) {
  const Mesh &mesh = surface.cut.mesh, &remesh = polygons.remesh();
  const Vec3& from = remesh.position(VertexId(std::min(cells.first, cells.second).value()));
  const Vec3& to = remesh.position(VertexId(std::max(cells.first, cells.second).value()));
  std::size_t begin = 1, end = path.size() - 1;
  if (!polygons.at(path.front())) {
    begin = 0, end = 1;
  } else if (!polygons.at(path.back())) {
    begin = path.size() - 1, end = path.size();
  }
  Least<BisectorCrossing, std::pair<double, VertexId>> nearest{{}, {kInfinity, {}}};
  for (std::size_t i = begin; i < end; ++i) {
    const Vec3& at = mesh.position(path[i]);
    const double t = std::clamp(foot_on_line(from, to, at), kLeastCrossing, 1 - kLeastCrossing);
    nearest.offer({(at - from - t * (to - from)).norm(), path[i]}, {i, t});
  }
  return nearest.value;
}

/// Appends the targets of a half of a run, from or to the centre of a polygon. `at`: how far the vertices are from the
/// centre. The bisector crosses the side that follows the corner of `side`.
void add_half(const DualPolygon& polygon, std::pair<GeneratorId, GeneratorId> cell_and_side,
              const std::vector<double>& at, std::span<const HalfedgeId> halfedges,
              std::vector<BorderTarget>& targets) {
  const auto& [cell, side] = cell_and_side;
  const Vec2 end = polygon.crossing(polygon.find(side)), apex = polygon.corner(polygon.find(cell));
  const auto target = [&](std::size_t i) -> Vec2 {
    return at[i] == 1 ? end : Vec2(polygon.centre + at[i] * (end - polygon.centre));
  };
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    targets.push_back({halfedges[i], &polygon, apex, target(i), target(i + 1), at[i], at[i + 1]});
  }
}

/// The targets of a cell's border, in its order, without the run along the mesh's boundary.
///
/// A run goes from the centre of a polygon to the centre of the next one. Between them it crosses the edge that joins
/// the two cells' vertices. The vertices are spaced by their distances. Both cells have the same targets, to the last
/// bit. Nothing if both ends of a run are on the boundary. Cost: O(k) for k halfedges.
std::optional<std::vector<BorderTarget>> collect_targets(const CellSurface& surface, const DualPolygons& polygons,
                                                         GeneratorId cell) {
  const Mesh& mesh = surface.cut.mesh;
  const CellBorder& border = surface.borders[cell];
  std::vector<BorderTarget> targets;
  for (const BorderRun& run : border.runs) {
    if (!run.other.valid()) continue;
    const Path path = run_vertices(mesh, border, run);
    const DualPolygon *before = polygons.at(path.front()), *behind = polygons.at(path.back());
    if (!before && !behind) return std::nullopt;
    const std::size_t middle = find_crossing(surface, polygons, path, {cell, run.other}).number;
    const auto at = path.begin() + std::ptrdiff_t(middle);
    const std::span<const HalfedgeId> halfedges(border.loop.data() + run.begin, run.end - run.begin);
    if (before) {
      add_half(*before, {cell, run.other}, space(mesh, {path.begin(), at + 1}, kEvenShare), halfedges, targets);
    }
    if (!behind) continue;
    std::vector<double> spaced = space(mesh, {path.rbegin(), std::make_reverse_iterator(at)}, kEvenShare);
    std::reverse(spaced.begin(), spaced.end());
    add_half(*behind, {cell, cell}, spaced, halfedges.subspan(middle), targets);
  }
  return targets;
}

/// The weight of even spacing in the angles between vertices on a circle, and in the spacing of vertices on a straight
/// side. Without it, rounding could leave the triangle of three of them without area.
constexpr double kEvenSector = 0.1;

/// Bounds of the angle of a sector. A straight angle would let edges between its two sides fall onto them.
constexpr double kLeastSector = std::numbers::pi / 3, kLargestSector = 0.95 * std::numbers::pi;

/// How far the sides of a star are bent outwards, as a fraction of their distance. Without it, triangles of three
/// vertices of one side would have no area.
constexpr double kBulge = 0.02;

/// How the border of a cell is laid into the plane, around the origin.
enum class BorderShape {
  star,   ///< by angles and distances at the remesh's vertex: nearly the shape of the remesh's part
  round,  ///< on a circle: convex
};

/// The border of a cell in the plane. For a cell at the boundary it is a sector whose corner, at the origin, is the
/// anchor, and whose two straight sides are the run along the boundary.
struct PlaneBorder {
  std::vector<DiscBorderPoint> points;
  std::vector<Vec2> bases;  ///< of the ends of the targets, one more than targets; round: the first one again
};

/// Angles and distances of the targets' ends, seen from the remesh's vertex; one more than targets. The last angle is
/// the whole way around.
struct PolarEnds {
  std::vector<double> angles, radii;
};

PolarEnds measure_ends(const Mesh& remesh, GeneratorId cell, const std::vector<BorderTarget>& targets) {
  const Vec3& at = remesh.position(VertexId(cell.value()));
  const auto offset = [&](const BorderTarget& t, const Vec2& point) -> Vec3 {
    return position(remesh, t.polygon->on_remesh(point)) - at;
  };
  PolarEnds ends{{0}, {}};
  for (const BorderTarget& t : targets) {
    const Vec3 from = offset(t, t.from), to = offset(t, t.to);
    ends.angles.push_back(ends.angles.back() + std::atan2(from.cross(to).norm(), from.dot(to)));
    ends.radii.push_back(from.norm() * (1 + kBulge * t.at_from * (1 - t.at_from)));
  }
  ends.radii.push_back(offset(targets.back(), targets.back().to).norm());
  return ends;
}

/// Places a sector in a frame of its two sides, so that points on them lie on one line without rounding.
std::vector<Vec2> lay_sector(PolarEnds ends, double even_share) {
  auto& [angles, radii] = ends;
  const double sector = std::clamp(angles.back(), kLeastSector, kLargestSector);
  scale_and_even(angles, sector, even_share);
  std::vector<Vec2> bases;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double along = std::sin(angles[i]) / std::sin(sector);
    bases.push_back(radii[i] * Vec2(std::cos(angles[i]) - along * std::cos(sector), along));
  }
  bases.front() = Vec2(radii.front(), 0);
  bases.back() = Vec2(0, radii.back());
  return bases;
}

/// The points of the run along the boundary, on the two straight sides of a sector.
void add_sides(const CellSurface& surface, GeneratorId cell, PlaneBorder& plane) {
  const Mesh& mesh = surface.cut.mesh;
  const CellBorder& border = surface.borders[cell];
  const std::vector<VertexId> vertices = run_vertices(mesh, border, border.runs.back());
  const auto anchor = std::find(vertices.begin(), vertices.end(), surface.anchors[cell]);
  const std::vector<double> down = space(mesh, {anchor, vertices.end()}, kEvenSector),
                            up = space(mesh, {std::make_reverse_iterator(anchor + 1), vertices.rend()}, kEvenSector);
  const std::size_t at = anchor - vertices.begin();
  const auto &right = plane.bases.front(), &left = plane.bases.back();
  for (std::size_t i = 0; i <= at; ++i) plane.points.push_back({vertices[i], Vec2(0, up[at - i] * left.y())});
  for (std::size_t i = 1; i + 1 < down.size(); ++i) {
    plane.points.push_back({vertices[at + i], Vec2(down[i] * right.x(), 0)});
  }
}

/// Lays the border of a cell into the plane. The cell has at least three `targets`, or two at the boundary. Cost: O(k)
/// for k halfedges.
PlaneBorder lay_border(const CellSurface& surface, const Mesh& remesh, GeneratorId cell,
                       const std::vector<BorderTarget>& targets, BorderShape shape) {
  PolarEnds ends = measure_ends(remesh, cell, targets);
  const bool is_star = shape == BorderShape::star;
  if (!is_star) ends.radii.assign(ends.radii.size(), 1);
  const double largest = *std::max_element(ends.radii.begin(), ends.radii.end());
  for (double& radius : ends.radii) radius /= largest;
  const double even_share = is_star ? 0 : kEvenSector;
  const bool is_sector = surface.borders[cell].at_boundary();
  PlaneBorder plane;
  if (is_sector) {
    plane.bases = lay_sector(std::move(ends), even_share);
  } else {
    scale_and_even(ends.angles, 2 * std::numbers::pi, even_share);
    plane.bases = lay_round(ends.angles, ends.radii);
    plane.bases.push_back(plane.bases.front());
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    plane.points.push_back({surface.cut.mesh.from(targets[i].halfedge), plane.bases[i]});
  }
  if (is_sector) add_sides(surface, cell, plane);
  return plane;
}

/// Largest distance of the fan's apex from the middle of the disc, whose radius is 1. Nearer to the border, triangles
/// of the fan would be thin.
constexpr double kLargestApex = 0.85;

/// The angle from u to v counter-clockwise, from 0 to 2 pi.
double angle_between(const Vec2& u, const Vec2& v) {
  const double angle = std::atan2(cross(u, v), u.dot(v));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

class CellFlattener {
 public:
  CellFlattener(const CellMapInput& input, GeneratorId cell, const std::vector<FaceId>& faces)
      : input_(input), mesh_(input.cells.cut.mesh), cell_(cell), faces_(faces) {
    plane_.vertex = VertexId(cell.value());
  }

  OrError<PlaneCell> run() {
    auto targets = collect_targets(input_.cells, input_.polygons, cell_);
    if (!targets) return fail("two cells touch from boundary to boundary");
    plane_.targets = *std::move(targets);
    using enum BorderShape;
    using enum DiscWeights;
    for (const auto& [shape, weights] : {std::pair(star, mean_value), {round, mean_value}, {round, uniform}}) {
      if (flatten(shape, weights)) return std::move(plane_);
    }
    return fail(fmt::format("the map of cell {} folds over", cell_.value()));
  }

 private:
  Error fail(const std::string& why) const { return {ErrorCode::no_valid_result, why, cell_.value()}; }

  bool is_sector() const { return input_.cells.borders[cell_].at_boundary(); }

  bool flatten(BorderShape shape, DiscWeights weights) {
    PlaneBorder border = lay_border(input_.cells, input_.polygons.remesh(), cell_, plane_.targets, shape);
    plane_.bases = std::move(border.bases);
    auto disc = flatten_disc(mesh_, faces_, border.points, weights);
    if (!disc || !is_oriented(mesh_, faces_, *disc)) return false;
    plane_.disc = *std::move(disc);
    is_sector() ? place_anchor() : place_apex();
    return is_fan();
  }

  /// Puts the apex at the image of the cell's point that is nearest to the remesh's vertex or, if that is too near the
  /// border, at the image of the generator. Faces that face away from the remesh are used only if there are no others.
  void place_apex() {
    const Mesh& remesh = input_.polygons.remesh();
    const Vec3& vertex = remesh.position(plane_.vertex);
    set_origin(find_nearest_facing(mesh_, faces_, vertex, surface_normal(remesh, vertex_point(remesh, plane_.vertex))));
    const Vec2 found = plane_.apex;
    plane_.apex /= kLargestApex;
    if (is_fan()) {
      plane_.apex = found;
      return;
    }
    const SurfacePoint& generator = input_.result.generators[cell_.index()];
    set_origin(find_nearest_facing(mesh_, faces_, position(input_.surface, generator),
                                   surface_normal(input_.surface, generator)));
  }

  void place_anchor() {
    const VertexId anchor = input_.cells.anchors[cell_];
    for (const FaceId f : faces_) {
      const auto& corners = mesh_.vertices(f);
      if (std::find(corners.begin(), corners.end(), anchor) == corners.end()) continue;
      plane_.origin = on_surface(f, mesh_.position(anchor));
      return;
    }
  }

  /// The point of the surface for a point of a face of the cut surface.
  SurfacePoint on_surface(FaceId f, const Vec3& point) const {
    return closest_point_on_face(input_.surface, input_.cells.cut.parent[f], point).point;
  }

  void set_origin(const SurfacePoint& point) {
    const auto& [a, b, c] = mesh_.vertices(point.face);
    const PlaneDisc& disc = plane_.disc;
    plane_.apex = interpolate(point.bary, disc.at(a), disc.at(b), disc.at(c));
    plane_.origin = on_surface(point.face, position(mesh_, point));
  }

  /// Whether the fan's triangles are counter-clockwise, for certain, and go round once. A sector can't go round.
  bool is_fan() const {
    int rounds = 0;
    for (std::size_t i = 0; i < plane_.targets.size(); ++i) {
      const Vec2 &a = plane_.bases[i], &b = plane_.bases[i + 1];
      if (orientation(plane_.apex, a, b) <= 0 || plane_.targets[i].at_from == plane_.targets[i].at_to) return false;
      rounds += a.y() < plane_.apex.y() && b.y() >= plane_.apex.y();
    }
    if (!is_sector()) return rounds == 1;
    return std::all_of(plane_.bases.begin(), plane_.bases.end(),
                       [](const Vec2& p) { return p.x() >= 0 && p.y() >= 0; });
  }

  const CellMapInput& input_;
  const Mesh& mesh_;
  GeneratorId cell_;
  const std::vector<FaceId>& faces_;
  PlaneCell plane_;
};

}  // namespace

void place_crossings(const CellSurface& surface, DualPolygons& polygons) {
  for (const GeneratorId g : surface.borders.ids()) {
    for (const BorderRun& run : surface.borders[g].runs) {
      if (run.other < g) continue;
      const Path path = run_vertices(surface.cut.mesh, surface.borders[g], run);
      const double t = find_crossing(surface, polygons, path, {g, run.other}).t;
      polygons.set_crossing(path.front(), run.other, 1 - t);
      polygons.set_crossing(path.back(), g, t);
    }
  }
}

SurfacePoint find_nearest_facing(const Mesh& mesh, const std::vector<FaceId>& faces, const Vec3& point,
                                 const Vec3& normal) {
  Least<SurfacePoint, std::pair<bool, double>> nearest{{}, {true, kInfinity}};
  for (const FaceId f : faces) {
    const ClosestPoint found = closest_point_on_face(mesh, f, point);
    nearest.offer({face_normal(mesh, f).dot(normal) < 0, found.distance}, found.point);
  }
  return nearest.value;
}

SurfacePoint PlaneCell::image(const Vec2& point) const {
  const Vec2 first = bases.front() - apex;
  const double angle = angle_between(first, point - apex);
  // The first base behind the angle, or else the last base, which may be the same point as the first one.
  const auto behind = std::upper_bound(bases.begin() + 1, bases.end() - 1, angle, [&](double value, const Vec2& base) {
    return value < angle_between(first, base - apex);
  });
  const std::size_t i = behind - bases.begin() - 1;
  const double area = twice_signed_area(apex, bases[i], bases[i + 1]);
  const double from = std::max(twice_signed_area(apex, point, bases[i + 1]) / area, 0.0),
               to = std::max(twice_signed_area(apex, bases[i], point) / area, 0.0);
  const double sum = std::max(from + to, 1.0);
  const BorderTarget& target = targets[i];
  const Vec2 at = target.apex + from / sum * (target.from - target.apex) + to / sum * (target.to - target.apex);
  return target.polygon->on_remesh(at);
}

OrError<PlaneCell> flatten_cell(const CellMapInput& input, GeneratorId cell, const std::vector<FaceId>& faces) {
  return CellFlattener(input, cell, faces).run();
}

}  // namespace gvd
