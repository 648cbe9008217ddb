// The map of one cell: its disc in the plane on one side, a fan of triangles on the other.
//
// On the remesh the cell's border runs from polygon to polygon, straight from a centre to a crossing on an edge and on
// to the next centre. In the plane it is a star with nearly the shape of that part of the remesh, or a circle. The
// vertices of each straight piece are spaced by their distances on the surface, a little evened out so that none
// coincide. Both cells of a bisector compute the same numbers for it: the map fits together to the last bit. The disc
// holds the faces of the surface, the fan the cell's part of the remesh. They have the same border, so a point goes
// from the surface to the plane by its face, and from there to the remesh by its triangle of the fan. Shapes and
// weights are tried in turn, from the best looking to the safest, until no triangle of either side is turned round. The
// signs are certain, so a cell that passes is mapped one-to-one: docs/developer/proofs.md, section 7.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "base/barycentric.hpp"
#include "base/least.hpp"
#include "base/plane.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "map/map_steps.hpp"

namespace gvd {

std::vector<double> lengths_along(const Mesh& mesh, const std::vector<VertexId>& path) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    lengths.push_back(lengths.back() + (mesh.position(path[i]) - mesh.position(path[i - 1])).norm());
  }
  return lengths;
}

void scale_and_even(std::vector<double>& values, double last, double even_share) {
  const double given = values.back(), steps = double(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = last * ((1 - even_share) * values[i] / given + even_share * double(i) / steps);
  }
  values.back() = last;
}

namespace {

/// Share of even spacing in the spacing of a path's vertices. It keeps those apart that nearly coincide.
constexpr double kEvenShare = 0.01;

/// Numbers from 0 to 1 for the vertices of a path, ascending, by their distances.
std::vector<double> space(const Mesh& mesh, const std::vector<VertexId>& path, double even_share) {
  std::vector<double> at = lengths_along(mesh, path);
  scale_and_even(at, 1, even_share);
  return at;
}

using Path = std::vector<VertexId>;

/// Bounds of a crossing on its edge, from 0 to 1: near an end it would squeeze the triangles of one of the cells' fans.
constexpr double kLeastCrossing = 0.1;

/// The point where a bisector crosses the edge between the remesh's vertices of its cells.
struct Crossing {
  std::size_t number = 0;  ///< of the bisector's vertex
  double t = 0.5;          ///< on the edge, from the vertex of the cell with the smaller id
};

/// The vertex of a path that is nearest to the edge, the same from both sides: an end on the boundary, or an inner one.
Crossing find_crossing(const CellSurface& surface, const DualPolygons& polygons, const Path& path,
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
  Least<Crossing, std::pair<double, VertexId>> nearest{{}, {kInfinity, {}}};
  for (std::size_t i = begin; i < end; ++i) {
    const Vec3& at = mesh.position(path[i]);
    const double t = std::clamp(foot_on_line(from, to, at), kLeastCrossing, 1 - kLeastCrossing);
    nearest.offer({(at - from - t * (to - from)).norm(), path[i]}, {i, t});
  }
  return nearest.value;
}

/// The targets of a cell's border, in its order, without the run along the mesh's boundary.
///
/// A run goes from the centre of a polygon to the centre of the next one. Between them it crosses the edge that joins
/// the two cells' vertices. The vertices are spaced by their distances. Both cells have the same targets, to the last
/// bit. Throws Error{no_valid_result} where a run joins boundary and boundary. Cost: O(k) for k halfedges.
class TargetCollector {
 public:
  TargetCollector(const CellSurface& surface, const DualPolygons& polygons, GeneratorId cell)
      : surface_(surface), mesh_(surface.cut.mesh), border_(surface.borders[cell]), polygons_(polygons), cell_(cell) {}

  std::vector<BorderTarget> run() {
    for (const BorderRun& r : border_.runs) {
      if (r.other.valid()) add(r);
    }
    return std::move(targets_);
  }

 private:
  void add(const BorderRun& r) {
    const Path path = run_vertices(mesh_, border_, r);
    const DualPolygon *before = polygons_.at(path.front()), *behind = polygons_.at(path.back());
    if (!before && !behind) {
      throw Error(ErrorCode::no_valid_result, "two cells touch from boundary to boundary", cell_.value());
    }
    const std::size_t middle = find_crossing(surface_, polygons_, path, {cell_, r.other}).number;
    const auto at = path.begin() + middle;
    if (before) add_half(*before, r.other, space(mesh_, {path.begin(), at + 1}, kEvenShare), r.begin);
    if (!behind) return;
    std::vector<double> spaced = space(mesh_, {path.rbegin(), std::make_reverse_iterator(at)}, kEvenShare);
    std::reverse(spaced.begin(), spaced.end());
    add_half(*behind, cell_, spaced, r.begin + middle);
  }

  /// `at`: how far the vertices are from the polygon's centre. The bisector crosses the side behind the corner of
  /// `side`.
  void add_half(const DualPolygon& polygon, GeneratorId side, const std::vector<double>& at, std::size_t first) {
    const Vec2 end = polygon.crossing(polygon.find(side)), apex = polygon.corner(polygon.find(cell_));
    const auto target = [&](std::size_t i) -> Vec2 {
      return at[i] == 1 ? end : Vec2(polygon.centre + at[i] * (end - polygon.centre));
    };
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      targets_.push_back({border_.loop[first + i], &polygon, apex, target(i), target(i + 1), at[i], at[i + 1]});
    }
  }

  const CellSurface& surface_;
  const Mesh& mesh_;
  const CellBorder& border_;
  const DualPolygons& polygons_;
  GeneratorId cell_;
  std::vector<BorderTarget> targets_;
};

/// Share of even spacing in the angles between vertices on a circle, and in the spacing of vertices on a straight side.
/// Without it, triangles of three of them could have no area within rounding.
constexpr double kEvenSector = 0.1;

/// Bounds of the angle of a sector. A straight angle would let edges between its two sides fall onto them.
constexpr double kLeastSector = std::numbers::pi / 3, kLargestSector = 0.95 * std::numbers::pi;

/// How far the sides of a star are bent outwards, as a fraction of their distance. Without it, triangles of three
/// vertices of one side would have no area.
constexpr double kBulge = 0.02;

/// How the border of a cell is put into the plane, round the origin.
enum class BorderShape {
  star,   ///< by angles and distances at the remesh's vertex: nearly the shape of the remesh's part
  round,  ///< on a circle: convex
};

/// The border of a cell in the plane. That of a cell at the boundary is a sector, whose corner is the anchor, at the
/// origin. Its two straight sides are the run along the boundary.
struct PlaneBorder {
  std::vector<BorderPoint> points;
  std::vector<Vec2> bases;  ///< of the ends of the targets, one more than targets; round: the first one again
};

/// Puts the border of a cell into the plane. `targets`: those of the cell; at least three, or two at the boundary.
/// Cost: O(k) for k halfedges.
class BorderPlacer {
 public:
  BorderPlacer(const CellSurface& surface, const Mesh& remesh, GeneratorId cell,
               const std::vector<BorderTarget>& targets)
      : surface_(surface), mesh_(surface.cut.mesh), remesh_(remesh), cell_(cell), targets_(targets) {}

  PlaneBorder run(BorderShape shape) {
    measure();
    const bool is_star = shape == BorderShape::star;
    if (!is_star) radii_.assign(radii_.size(), 1);
    const double largest = *std::max_element(radii_.begin(), radii_.end());
    for (double& radius : radii_) radius /= largest;
    const double even_share = is_star ? 0 : kEvenSector;
    const bool is_sector = surface_.borders[cell_].at_boundary();
    is_sector ? place_sector(even_share) : place_round(even_share);
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      border_.points.push_back({mesh_.from(targets_[i].halfedge), border_.bases[i]});
    }
    if (is_sector) place_sides();
    return std::move(border_);
  }

 private:
  /// Angles and distances of the targets' ends at the remesh's vertex.
  void measure() {
    const Vec3& at = remesh_.position(VertexId(cell_.value()));
    const auto offset = [&](const BorderTarget& t, const Vec2& point) -> Vec3 {
      return position(remesh_, t.polygon->on_remesh(point)) - at;
    };
    angles_.push_back(0);
    for (const BorderTarget& t : targets_) {
      const Vec3 from = offset(t, t.from), to = offset(t, t.to);
      angles_.push_back(angles_.back() + std::atan2(from.cross(to).norm(), from.dot(to)));
      radii_.push_back(from.norm() * (1 + kBulge * t.at_from * (1 - t.at_from)));
    }
    radii_.push_back(offset(targets_.back(), targets_.back().to).norm());
  }

  void place_round(double even_share) {
    scale_and_even(angles_, 2 * std::numbers::pi, even_share);
    for (std::size_t i = 0; i < targets_.size(); ++i) border_.bases.push_back(radii_[i] * unit_vector(angles_[i]));
    border_.bases.push_back(border_.bases.front());
  }

  /// Places a sector in a frame of its two sides, so that points on them lie on one line without rounding.
  void place_sector(double even_share) {
    const double sector = std::clamp(angles_.back(), kLeastSector, kLargestSector);
    scale_and_even(angles_, sector, even_share);
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      const double along = std::sin(angles_[i]) / std::sin(sector);
      border_.bases.push_back(radii_[i] * Vec2(std::cos(angles_[i]) - along * std::cos(sector), along));
    }
    border_.bases.front() = Vec2(radii_.front(), 0);
    border_.bases.back() = Vec2(0, radii_.back());
  }

  void place_sides() {
    const CellBorder& border = surface_.borders[cell_];
    const std::vector<VertexId> vertices = run_vertices(mesh_, border, border.runs.back());
    const auto anchor = std::find(vertices.begin(), vertices.end(), surface_.anchors[cell_]);
    const std::vector<double> down = space(mesh_, {anchor, vertices.end()}, kEvenSector),
                              up = space(mesh_, {std::make_reverse_iterator(anchor + 1), vertices.rend()}, kEvenSector);
    const std::size_t at = anchor - vertices.begin();
    const auto &right = border_.bases.front(), &left = border_.bases.back();
    for (std::size_t i = 0; i <= at; ++i) border_.points.push_back({vertices[i], Vec2(0, up[at - i] * left.y())});
    for (std::size_t i = 1; i + 1 < down.size(); ++i) {
      border_.points.push_back({vertices[at + i], Vec2(down[i] * right.x(), 0)});
    }
  }

  const CellSurface& surface_;
  const Mesh& mesh_;
  const Mesh& remesh_;
  GeneratorId cell_;
  const std::vector<BorderTarget>& targets_;
  std::vector<double> angles_, radii_;  // of the bases
  PlaneBorder border_;
};

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
    plane_.targets = TargetCollector(input.cells, input.polygons, cell).run();
  }

  PlaneCell run() {
    using enum BorderShape;
    using enum DiscWeights;
    for (const auto& [shape, weights] : {std::pair(star, mean_value), {round, mean_value}, {round, uniform}}) {
      if (flatten(shape, weights)) return std::move(plane_);
    }
    throw Error(ErrorCode::no_valid_result, fmt::format("the map of cell {} folds over", cell_.value()), cell_.value());
  }

 private:
  bool is_sector() const { return input_.cells.borders[cell_].at_boundary(); }

  bool flatten(BorderShape shape, DiscWeights weights) {
    PlaneBorder border = BorderPlacer(input_.cells, input_.result.mesh, cell_, plane_.targets).run(shape);
    plane_.bases = std::move(border.bases);
    plane_.disc = flatten_disc(mesh_, faces_, border.points, weights);
    if (!is_oriented(mesh_, faces_, plane_.disc)) return false;
    is_sector() ? place_anchor() : place_apex();
    return is_fan();
  }

  /// Puts the apex where the disc has the point of the cell that is nearest to the remesh's vertex. If that is too near
  /// the border, it takes the generator. Faces that are turned away from the remesh count only if there are no others.
  void place_apex() {
    const Vec3& vertex = input_.result.mesh.position(plane_.vertex);
    set_origin(find_nearest_facing(
        mesh_, faces_, vertex, surface_normal(input_.result.mesh, vertex_point(input_.result.mesh, plane_.vertex))));
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
  // The base behind the first one, to the last one, whose end may be the first base again.
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

PlaneCell flatten_cell(const CellMapInput& input, GeneratorId cell, const std::vector<FaceId>& faces) {
  return CellFlattener(input, cell, faces).run();
}

}  // namespace gvd
