#include "map/plane_border.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/plane.hpp"
#include "map/path_spacing.hpp"

namespace gvd {
namespace {

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
    surface_.borders[cell_].at_boundary() ? place_sector(even_share) : place_round(even_share);
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
    place_bases();
  }

  /// In a frame of the two sides, so that points on them lie on one line without rounding.
  void place_sector(double even_share) {
    const double sector = std::clamp(angles_.back(), kLeastSector, kLargestSector);
    scale_and_even(angles_, sector, even_share);
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      const double along = std::sin(angles_[i]) / std::sin(sector);
      border_.bases.push_back(radii_[i] * Vec2(std::cos(angles_[i]) - along * std::cos(sector), along));
    }
    border_.bases.front() = Vec2(radii_.front(), 0);
    border_.bases.back() = Vec2(0, radii_.back());
    place_bases();
    place_sides();
  }

  void place_bases() {
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      border_.points.push_back({mesh_.from(targets_[i].halfedge), border_.bases[i]});
    }
  }

  void place_sides() {
    const CellBorder& border = surface_.borders[cell_];
    const std::vector<VertexId> vertices = run_vertices(mesh_, border, border.runs.back());
    const auto anchor = std::find(vertices.begin(), vertices.end(), surface_.anchors[cell_]);
    const std::vector<double> down = fractions({anchor, vertices.end()}),
                              up = fractions({std::make_reverse_iterator(anchor + 1), vertices.rend()});
    const auto at = static_cast<std::size_t>(anchor - vertices.begin());
    const auto &right = border_.bases.front(), &left = border_.bases.back();
    for (std::size_t i = 0; i <= at; ++i) border_.points.push_back({vertices[i], Vec2(0, up[at - i] * left.y())});
    for (std::size_t i = 1; i + 1 < down.size(); ++i) {
      border_.points.push_back({vertices[at + i], Vec2(down[i] * right.x(), 0)});
    }
  }

  /// Numbers from 0 to 1 for the vertices of a path, ascending, by their distances.
  std::vector<double> fractions(const std::vector<VertexId>& path) const {
    std::vector<double> at = lengths_along(mesh_, path);
    scale_and_even(at, 1, kEvenSector);
    return at;
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

PlaneBorder place_border(const CellSurface& surface, const Mesh& remesh, GeneratorId cell,
                         const std::vector<BorderTarget>& targets, BorderShape shape) {
  return BorderPlacer(surface, remesh, cell, targets).run(shape);
}

}  // namespace gvd
