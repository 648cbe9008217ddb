#include "place_generators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "boundary_runs.hpp"
#include "cell_loops.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

class Placer {
 public:
  Placer(const Mesh& mesh, const Diagram& diagram, std::size_t room)
      : mesh_(mesh),
        diagram_(diagram),
        room_(room),
        component_(compute_face_components(mesh)),
        taken_(diagram.generators.size(), 0) {
    for (const SurfacePoint& g : diagram.generators) occupy(g);
  }

  std::vector<SurfacePoint> place(const std::vector<DualDefect>& defects) {
    for (const DualDefect& defect : defects) {
      if (points_.size() == room_) break;
      if (is_taken(defect)) continue;
      const std::size_t before = points_.size();
      repair(defect);
      if (points_.size() == before) continue;
      for (const GeneratorId g : defect.cells) taken_[g] = 1;
    }
    return std::move(points_);
  }

 private:
  /// Whether a repair of this call touches the defect's cells, or the neighbours of a cell that has too few.
  bool is_taken(const DualDefect& defect) const {
    const auto any = [&](const std::vector<GeneratorId>& cells) {
      return std::any_of(cells.begin(), cells.end(), [&](GeneratorId g) { return taken_[g] != 0; });
    };
    return any(defect.cells) ||
           (defect.property == DualProperty::enough_neighbours && any(diagram_.cells[defect.cells[0]].neighbours));
  }

  void repair(const DualDefect& defect) {
    switch (defect.property) {
      case DualProperty::component_reached:
        return reach_component(defect.component);
      case DualProperty::cell_is_disc:
        return part_loop(defect.cells[0]);
      case DualProperty::one_boundary_run:
        return part_boundary(defect.cells[0]);
      case DualProperty::bisector_has_face:
        return give_face(diagram_.bisectors[defect.bisector]);
      case DualProperty::one_bisector:
        return part_pair(defect.cells[0], defect.cells[1]);
      case DualProperty::enough_neighbours:
        return add_farthest(defect.cells[0]);
      case DualProperty::one_branch_point:
        return part_triple(defect.branch_point);
      case DualProperty::different_cells:
      case DualProperty::polygon_fits:
      case DualProperty::not_flipped:
        return part_branch(defect.branch_point);
    }
  }

  bool add(const SurfacePoint& point) {
    const double least = kLeastSpacing * mesh_.bbox_diagonal();
    if (points_.size() == room_ || !(clearance(point) > least)) return false;
    occupy(point);
    points_.push_back(point);
    return true;
  }

  void occupy(const SurfacePoint& point) {
    occupied_.push_back(position(mesh_, point));
    occupied_component_.push_back(component_[point.face]);
  }

  /// From the nearest generator of the same component: others may touch it.
  double clearance(const SurfacePoint& point) const {
    const Vec3 at = position(mesh_, point);
    const std::int32_t component = component_[point.face];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < occupied_.size(); ++i) {
      if (occupied_component_[i] == component) least = std::min(least, (occupied_[i] - at).squaredNorm());
    }
    return std::sqrt(least);
  }

  double distance(const SurfacePoint& point, GeneratorId g) const {
    return (position(mesh_, point) - occupied_[g.index()]).norm();
  }

  void reach_component(std::int32_t component) {
    const FaceId f(std::find(component_.begin(), component_.end(), component) - component_.begin());
    add(vertex_point(mesh_, mesh_.vertices(f)[0]));
  }

  void part_loop(GeneratorId g) {
    const std::size_t before = points_.size();
    if (CellLoops* loops = cell_loops()) {
      for (const SurfacePoint& p : loops->find(g)) add(p);
    }
    if (points_.size() == before) add_farthest(g);
  }

  /// Null where the bisectors cut the mesh into something that is none: two edges with the same ends.
  CellLoops* cell_loops() {
    if (!loops_ && can_cut_) {
      try {
        loops_.emplace(mesh_, diagram_);
      } catch (const Error& error) {
        if (error.code() != ErrorCode::no_valid_result) throw;
        can_cut_ = false;
      }
    }
    return loops_ ? &*loops_ : nullptr;
  }

  /// A generator opposite to g, on the run that is farthest from it, takes that run and leaves g another one.
  void part_boundary(GeneratorId g) {
    if (!runs_) runs_ = list_boundary_runs(mesh_, diagram_);
    std::vector<SurfacePoint> places;
    for (const BoundaryRun& run : *runs_) {
      if (run.cell == g) places.push_back(nearest_point(mesh_, run, occupied_[g.index()]));
    }
    add_best(places, [&](const SurfacePoint& p) { return distance(p, g); });
  }

  void give_face(const Bisector& b) {
    const auto farther = [&](const SurfacePoint& p) { return distance(p, b.left) + distance(p, b.right); };
    if (b.closed) return add_best(b.points, farther);
    add_best({b.points.front(), b.points.back()}, farther);
  }

  void part_pair(GeneratorId a, GeneratorId b) {
    const Bisector* best = nullptr;
    double most = -1;
    for (const Bisector& c : diagram_.bisectors) {
      if (std::minmax(c.left, c.right) != std::minmax(a, b)) continue;
      // A new cell reaches about half as far along the bisector as its generator is from theirs.
      const double ratio = distance(middle(c), a) / std::max(length(c), std::numeric_limits<double>::min());
      if (ratio > most) std::tie(most, best) = std::tuple(ratio, &c);
    }
    if (!add(middle(*best))) add_best(best->points, [&](const SurfacePoint& p) { return distance(p, a); });
  }

  void part_triple(BranchPointId branch) {
    const auto sorted = [&](const BranchPoint& b) {
      std::vector<GeneratorId> cells = b.generators;
      std::sort(cells.begin(), cells.end());
      return cells;
    };
    const auto cells = sorted(diagram_.branch_points[branch]);
    std::vector<SurfacePoint> places;
    for (const BranchPoint& b : diagram_.branch_points) {
      if (sorted(b) == cells) places.push_back(b.point);
    }
    add_best(places, [&](const SurfacePoint& p) { return distance(p, cells[0]); });
  }

  /// The point of the branch point or of the bisectors between its cells that is farthest from all generators. Where
  /// distances are accurate that is hardly ever far from the branch point; where they are not, it may lie near one of
  /// its generators, and another one beside it would help nobody.
  void part_branch(BranchPointId branch) {
    std::vector<GeneratorId> cells = diagram_.branch_points[branch].generators;
    const auto among = [&](GeneratorId g) { return std::find(cells.begin(), cells.end(), g) != cells.end(); };
    std::vector<SurfacePoint> places{diagram_.branch_points[branch].point};
    for (const Bisector& b : diagram_.bisectors) {
      if (among(b.left) && among(b.right)) places.insert(places.end(), b.points.begin(), b.points.end());
    }
    add_best(places, [&](const SurfacePoint& p) { return clearance(p); });
  }

  /// The cell's farthest vertex that is free; where it has none, the farthest point of its bisectors.
  void add_farthest(GeneratorId g) {
    std::vector<SurfacePoint> places;
    const std::size_t before = points_.size();
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
      const VertexId v(i);
      if (diagram_.vertex_label[v] == g) places.push_back(vertex_point(mesh_, v));
    }
    add_best(places, [&](const SurfacePoint& p) { return diagram_.vertex_distance[vertex(mesh_, p)]; });
    if (points_.size() > before) return;
    places.clear();
    for (const Bisector& b : diagram_.bisectors) {
      if (b.left == g || b.right == g) places.insert(places.end(), b.points.begin(), b.points.end());
    }
    add_best(places, [&](const SurfacePoint& p) { return distance(p, g); });
  }

  /// Adds the first free one of `places` in the order of falling `value`.
  template <class Value>
  void add_best(const std::vector<SurfacePoint>& places, Value value) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < places.size(); ++i) order.emplace_back(-value(places[i]), i);
    std::sort(order.begin(), order.end());
    for (const auto& [ignored, i] : order) {
      if (add(places[i])) return;
    }
  }

  double length(const Bisector& b) const {
    double sum = 0;
    for (std::size_t i = 1; i < b.points.size(); ++i) {
      sum += (position(mesh_, b.points[i]) - position(mesh_, b.points[i - 1])).norm();
    }
    return sum;
  }

  /// Half way along an open bisector.
  SurfacePoint middle(const Bisector& b) const {
    const double half = 0.5 * length(b);
    double sum = 0;
    for (std::size_t i = 1; i < b.points.size(); ++i) {
      const double step = (position(mesh_, b.points[i]) - position(mesh_, b.points[i - 1])).norm();
      if (sum + step >= half) return half - sum < 0.5 * step ? b.points[i - 1] : b.points[i];
      sum += step;
    }
    return b.points.back();
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::size_t room_;
  IdVector<FaceId, std::int32_t> component_;
  IdVector<GeneratorId, char> taken_;
  std::vector<Vec3> occupied_;  // the generators' positions, then those of the new ones
  std::vector<std::int32_t> occupied_component_;
  std::vector<SurfacePoint> points_;
  std::optional<CellLoops> loops_;
  bool can_cut_ = true;
  std::optional<std::vector<BoundaryRun>> runs_;
};

}  // namespace

std::vector<SurfacePoint> place_generators(const Mesh& mesh, const Diagram& diagram,
                                           const std::vector<DualDefect>& defects, std::size_t room) {
  return Placer(mesh, diagram, room).place(defects);
}

}  // namespace gvd
