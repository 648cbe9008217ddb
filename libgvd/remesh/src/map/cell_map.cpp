// The map of one cell: its disc in the plane on one side, a fan of triangles on the other.
//
// The disc holds the faces of the surface, the fan the cell's part of the remesh. They have the same border, so a point
// goes from the surface to the plane by its face, and from there to the remesh by its triangle of the fan. Shapes and
// weights are tried in turn, from the best looking to the safest, until no triangle of either side is turned round. The
// signs are certain, so a cell that passes is mapped one-to-one: docs/developer/proofs.md, section 7.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
namespace {

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
    plane_.targets = border_targets(input.cells, input.polygons, cell);
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
    PlaneBorder border = place_border(input_.cells, input_.result.mesh, cell_, plane_.targets, shape);
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
