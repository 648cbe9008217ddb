// Positions of the border of a cell: on the remesh, and in the plane.
//
// On the remesh a border runs from polygon to polygon, straight from a centre to a crossing on an edge and on to the
// next centre. In the plane it is a star with nearly the shape of that part of the remesh, or a circle. The vertices of
// each straight piece are spaced by their distances on the surface, a little evened out so that none coincide. Both
// cells of a bisector compute the same numbers for it: the map fits together to the last bit.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "base/least.hpp"
#include "base/plane.hpp"
#include "gvd/error.hpp"
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

std::vector<BorderTarget> border_targets(const CellSurface& surface, const DualPolygons& polygons, GeneratorId cell) {
  return TargetCollector(surface, polygons, cell).run();
}

PlaneBorder place_border(const CellSurface& surface, const Mesh& remesh, GeneratorId cell,
                         const std::vector<BorderTarget>& targets, BorderShape shape) {
  return BorderPlacer(surface, remesh, cell, targets).run(shape);
}

}  // namespace gvd
