#include "map/border_targets.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "gvd/error.hpp"
#include "map/path_spacing.hpp"

namespace gvd {
namespace {

/// Share of even spacing in the spacing of a path's vertices. It keeps those apart that nearly coincide.
constexpr double kEvenShare = 0.01;

/// Numbers from 0 to 1 for the vertices of a path, ascending, by their distances.
std::vector<double> space(const Mesh& mesh, const std::vector<VertexId>& path) {
  std::vector<double> at = lengths_along(mesh, path);
  scale_and_even(at, 1, kEvenShare);
  return at;
}

using Path = std::vector<VertexId>;

/// Bounds of a crossing on its edge, from 0 to 1: near an end it would squeeze the triangles of one of the cells' fans.
constexpr double kLeastCrossing = 0.1;

/// Where a bisector crosses the edge between the remesh's vertices of its cells.
struct Crossing {
  std::size_t number = 0;  ///< of the bisector's vertex
  double t = 0.5;          ///< on the edge, from the vertex of the cell with the smaller id
};

/// The vertex of a path that is nearest to the edge, the same from both sides: an end on the boundary, or an inner one.
Crossing find_crossing(const CellSurface& surface, const DualPolygons& polygons, const Path& path,
                       std::pair<GeneratorId, GeneratorId> cells) {
  const Mesh &mesh = surface.cut.mesh, &remesh = polygons.remesh();
  const Vec3& from = remesh.position(VertexId(std::min(cells.first, cells.second).value()));
  const Vec3 along = remesh.position(VertexId(std::max(cells.first, cells.second).value())) - from;
  const std::size_t last = path.size() - 1,
                    begin = !polygons.at(path.front())  ? 0
                            : !polygons.at(path.back()) ? last
                                                        : 1,
                    end = !polygons.at(path.front())  ? 1
                          : !polygons.at(path.back()) ? last + 1
                                                      : last;
  Crossing best;
  std::tuple<double, VertexId> least(std::numeric_limits<double>::infinity(), VertexId());
  for (std::size_t i = begin; i < end; ++i) {
    const Vec3 offset = mesh.position(path[i]) - from;
    const double t = std::clamp(along.dot(offset) / along.squaredNorm(), kLeastCrossing, 1 - kLeastCrossing);
    const std::tuple rank((offset - t * along).norm(), path[i]);
    if (rank >= least) continue;
    least = rank;
    best = {i, t};
  }
  return best;
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
    const auto at = path.begin() + static_cast<std::ptrdiff_t>(middle);
    if (before) add_half(*before, before->crossing(before->find(r.other)), {path.begin(), at + 1}, r.begin);
    if (!behind) return;
    const std::size_t first = targets_.size();
    add_half(*behind, behind->crossing(behind->find(cell_)), {path.rbegin(), std::make_reverse_iterator(at)},
             r.begin + middle);
    reverse_from(first, r.begin + middle);
  }

  /// `path` begins at the polygon's vertex.
  void add_half(const DualPolygon& polygon, const Vec2& end, const Path& path, std::size_t first) {
    const std::vector<double> at = space(mesh_, path);
    const auto target = [&](std::size_t i) -> Vec2 {
      return at[i] == 1 ? end : Vec2(polygon.centre + at[i] * (end - polygon.centre));
    };
    const Vec2 apex = polygon.corner(polygon.find(cell_));
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      targets_.push_back({border_.loop[first + i], &polygon, apex, target(i), target(i + 1), at[i], at[i + 1]});
    }
  }

  void reverse_from(std::size_t first, std::size_t halfedge) {
    std::reverse(targets_.begin() + static_cast<std::ptrdiff_t>(first), targets_.end());
    for (std::size_t i = first; i < targets_.size(); ++i) {
      std::swap(targets_[i].from, targets_[i].to);
      std::swap(targets_[i].at_from, targets_[i].at_to);
      targets_[i].halfedge = border_.loop[halfedge + i - first];
    }
  }

  const CellSurface& surface_;
  const Mesh& mesh_;
  const CellBorder& border_;
  const DualPolygons& polygons_;
  GeneratorId cell_;
  std::vector<BorderTarget> targets_;
};

}  // namespace

void place_crossings(const CellSurface& surface, DualPolygons& polygons) {
  for (std::size_t i = 0; i < surface.borders.size(); ++i) {
    const GeneratorId g(i);
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

}  // namespace gvd
