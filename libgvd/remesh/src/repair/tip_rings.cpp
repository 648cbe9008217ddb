// Generators that divide a cell round a tip, as three at one distance from it.
//
// If the cell of one generator surrounds a tip, which is a vertex with a total angle below pi, the cell is an annulus.
// Two more generators on the circle through it round the tip make three cells of it. They are the ends of straight
// lines from the tip; an exact field of distances from the tips checks that these are shortest paths. At a very sharp
// tip the circle is too short for three generators: such a tip is reported as narrow.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/least.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"
#include "repair/added_generators.hpp"
#include "repair/cell_topology.hpp"

namespace gvd {
namespace {

/// Largest relative difference between the length of a straight line and the distance of its end for which the line
/// counts as a shortest path. Distances are right to 1e-13 of themselves; a line across a fold is longer by far.
constexpr double kStraightTolerance = 1e-9;

/// The positions of the two new points of a ring, as fractions of a full turn from the generator. Equal angles are best
/// on a round tip. On a flat tip, which is folded along two lines, points at equal angles coincide in space if the
/// generator lies on a fold.
constexpr std::array<std::pair<double, double>, 3> kRingTurns{
    {{1.0 / 3, 2.0 / 3}, {1.0 / 4, 1.0 / 2}, {1.0 / 2, 3.0 / 4}}};

Vec2 turned(const Vec2& v, double turn) { return Eigen::Rotation2Dd(2 * std::numbers::pi * turn) * v; }

double least_distance(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c) {
  const Vec3 p = position(mesh, a), q = position(mesh, b), r = position(mesh, c);
  return std::min({(p - q).norm(), (q - r).norm(), (r - p).norm()});
}

bool is_annulus(const Cell& cell) {
  return cell.components == 1 && cell.euler_characteristic == 0 && cell.boundary_loops == 2;
}

/// The inner vertex of each cell with the least total angle; invalid for a cell without one.
IdVector<GeneratorId, VertexId> find_sharpest_vertices(const Mesh& mesh, const Diagram& diagram) {
  IdVector<GeneratorId, Least<VertexId>> least(diagram.generators.size());
  for (const VertexId v : mesh.vertices()) {
    const GeneratorId g = diagram.vertex_label[v];
    if (g.valid() && !mesh.is_boundary(v)) least[g].offer(total_angle(mesh, v), v);
  }
  IdVector<GeneratorId, VertexId> sharpest;
  for (const Least<VertexId>& of_cell : least) sharpest.push_back(of_cell.value);
  return sharpest;
}

}  // namespace

double total_angle(const Mesh& mesh, VertexId v) {
  double sum = 0;
  for_each_outgoing(mesh, v, [&](HalfedgeId h) { sum += corner_angle(mesh, h); });
  return sum;
}

TipRings::TipRings(const Mesh& mesh, const Diagram& diagram)
    : mesh_(mesh), diagram_(diagram), tips_(diagram.generators.size()) {
  if (std::none_of(diagram.cells.begin(), diagram.cells.end(), is_annulus)) return;
  const auto sharpest = find_sharpest_vertices(mesh, diagram);
  for (const Cell& cell : diagram.cells) {
    if (!is_annulus(cell)) continue;
    tips_[cell.generator] = find_tips(cell.generator, sharpest);
    sources_.insert(sources_.end(), tips_[cell.generator].begin(), tips_[cell.generator].end());
  }
  if (sources_.empty()) return;
  std::sort(sources_.begin(), sources_.end());
  sources_.erase(std::unique(sources_.begin(), sources_.end()), sources_.end());
  std::vector<SurfacePoint> points;
  for (const VertexId v : sources_) points.push_back(vertex_point(mesh, v));
  field_.emplace(mesh, points);
}

/// The sharpest vertex on each side of the annulus that is a tip. The largest side counts only if no other one has a
/// tip, because its sharpest vertex may be far away.
std::vector<VertexId> TipRings::find_tips(GeneratorId annulus, const IdVector<GeneratorId, VertexId>& sharpest) const {
  std::vector<std::pair<double, VertexId>> sides;  // area, tip
  for (const auto& side : list_sides(annulus)) {
    double area = 0;
    Least<VertexId> tip{VertexId(), kTipAngle};
    for (const GeneratorId g : side) {
      area += diagram_.cells[g].area;
      if (sharpest[g].valid()) tip.offer(total_angle(mesh_, sharpest[g]), sharpest[g]);
    }
    sides.emplace_back(area, tip.value);
  }
  std::sort(sides.begin(), sides.end());
  std::vector<VertexId> tips;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i].second.valid() && (i + 1 < sides.size() || tips.empty())) tips.push_back(sides[i].second);
  }
  return tips;
}

/// The cells on each side of an annulus: those that its neighbours reach from cell to cell without crossing it.
std::vector<std::vector<GeneratorId>> TipRings::list_sides(GeneratorId annulus) const {
  IdVector<GeneratorId, char> seen(diagram_.cells.size(), 0);
  seen[annulus] = 1;
  std::vector<std::vector<GeneratorId>> sides;
  for (const GeneratorId first : diagram_.cells[annulus].neighbours) {
    if (seen[first]) continue;
    seen[first] = 1;
    std::vector<GeneratorId> side{first};
    for (std::size_t i = 0; i < side.size(); ++i) {
      for (const GeneratorId next : diagram_.cells[side[i]].neighbours) {
        if (!seen[next]) side.push_back(next);
        seen[next] = 1;
      }
    }
    sides.push_back(std::move(side));
  }
  return sides;
}

/// Locates the cell's generator, seen from the tip that the cell surrounds.
std::optional<TipRings::Polar> TipRings::locate(GeneratorId cell) const {
  const std::vector<VertexId>& tips = tips_[cell];
  if (tips.empty()) return std::nullopt;
  const SurfacePoint& generator = diagram_.generators[cell.index()];
  const GeneratorId source = field_->nearest(generator).generator;
  if (!source.valid()) return std::nullopt;
  const Vec2 tangent = field_->departure(generator);
  const bool is_own = std::find(tips.begin(), tips.end(), sources_[source.index()]) != tips.end();
  if (!is_own || !(tangent.norm() > 0)) return std::nullopt;
  return Polar{source, tangent};
}

std::vector<SurfacePoint> TipRings::find(GeneratorId cell) const {
  const auto at = locate(cell);
  if (!at) return {};
  Least<std::vector<SurfacePoint>> best{{}, 0};
  for (const auto& [first, second] : kRingTurns) {
    const auto a = follow(at->source, turned(at->tangent, first)), b = follow(at->source, turned(at->tangent, second));
    if (a && b) best.offer(-least_distance(mesh_, diagram_.generators[cell.index()], *a, *b), {*a, *b});
  }
  return best.value;
}

std::optional<NarrowTip> TipRings::find_narrow_tip(GeneratorId cell) const {
  const auto at = locate(cell);
  if (!at) return std::nullopt;
  NarrowTip narrow;
  narrow.tip = sources_[at->source.index()];
  narrow.angle = total_angle(mesh_, narrow.tip);
  narrow.least_distance = 3 * kMinAddedSpacing * mesh_.bbox_diagonal() / narrow.angle;
  if (at->tangent.norm() >= narrow.least_distance) return std::nullopt;
  return narrow;
}

/// The end of a straight line from a tip, if no other way to it is shorter.
std::optional<SurfacePoint> TipRings::follow(GeneratorId source, const Vec2& tangent) const {
  const SurfacePoint start = vertex_point(mesh_, sources_[source.index()]);
  const GeodesicTrace line = trace_geodesic(mesh_, start, tangent);
  const auto [distance, nearest] = field_->nearest(line.points.back());
  if (!line.complete || nearest != source || distance < (1 - kStraightTolerance) * tangent.norm()) return std::nullopt;
  return line.points.back();
}

std::string describe(const Mesh& mesh, const NarrowTip& narrow) {
  const Vec3& at = mesh.position(narrow.tip);
  const std::string advice =
      narrow.least_distance < mesh.bbox_diagonal()
          ? fmt::format(
                "no generator may be nearer to it than {:.3g}; choose others, by another list, \1count\2 or "
                "\1seed\2",
                narrow.least_distance)
          : "cut the surface off there";
  return fmt::format(
      "the total angle of vertex {} at ({:.6g}, {:.6g}, {:.6g}) is {:.3g} degrees, and three generators "
      "round it would be too close to each other; {}",
      narrow.tip.value(), at.x(), at.y(), at.z(), narrow.angle * 180 / std::numbers::pi, advice);
}

}  // namespace gvd
