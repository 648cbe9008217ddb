#include "repair/repair_defect.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "gvd/error.hpp"
#include "repair/bisector_length.hpp"

namespace gvd {

void DefectRepair::repair(const DualDefect& defect) {
  switch (defect.property) {
    case DualProperty::component_reached:
      return add_to_component(defect.component);
    case DualProperty::cell_is_disc:
      return split_loop(defect.cells[0]);
    case DualProperty::one_boundary_arc:
      return split_boundary_arcs(defect.cells[0]);
    case DualProperty::bisector_has_face:
      return split_bisector(diagram_.bisectors[defect.bisector]);
    case DualProperty::one_bisector:
      return split_pair(defect.cells[0], defect.cells[1]);
    case DualProperty::enough_neighbours:
      return add_farthest(defect.cells[0]);
    case DualProperty::one_branch_point:
      return split_triple(defect.branch_point);
    case DualProperty::different_cells:
    case DualProperty::polygon_fits:
    case DualProperty::not_flipped:
    case DualProperty::no_self_intersection:
      return split_polygon(defect.branch_point);
  }
}

void DefectRepair::add_to_component(std::int32_t component) {
  const auto& of = added_.component();
  const FaceId f(std::find(of.begin(), of.end(), component) - of.begin());
  added_.add(vertex_point(mesh_, mesh_.vertices(f)[0]));
}

void DefectRepair::split_loop(GeneratorId g) {
  const std::size_t before = added_.size();
  for (const SurfacePoint& p : rings().find(g)) added_.add(p);
  if (added_.size() > before) return;
  if (CellLoops* loops = cell_loops()) {
    for (const SurfacePoint& p : loops->find(g)) added_.add(p);
  }
  if (added_.size() == before) add_farthest(g);
}

std::optional<NarrowTip> DefectRepair::find_narrow_tip(const DualDefect& defect) {
  if (defect.property != DualProperty::cell_is_disc) return std::nullopt;
  return rings().find_narrow_tip(defect.cells[0]);
}

const TipRings& DefectRepair::rings() {
  if (!rings_) rings_.emplace(mesh_, diagram_);
  return *rings_;
}

/// Null where cutting along the bisectors gives no manifold mesh: two edges would have the same ends.
CellLoops* DefectRepair::cell_loops() {
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

/// The new generator takes over the boundary arc that is farthest from g, so that g keeps the others.
void DefectRepair::split_boundary_arcs(GeneratorId g) {
  if (!arcs_) arcs_ = list_boundary_arcs(mesh_, diagram_);
  std::vector<SurfacePoint> candidates;
  for (const BoundaryArc& arc : *arcs_) {
    if (arc.cell == g) candidates.push_back(find_nearest_point(mesh_, arc, added_.position_of(g)));
  }
  added_.add_best(candidates, [&](const SurfacePoint& p) { return distance(p, g); });
}

void DefectRepair::split_bisector(const Bisector& b) {
  const auto value = [&](const SurfacePoint& p) { return distance(p, b.left) + distance(p, b.right); };
  if (b.closed) {
    added_.add_best(b.points, value);
  } else {
    added_.add_best({b.points.front(), b.points.back()}, value);
  }
}

void DefectRepair::split_pair(GeneratorId a, GeneratorId b) {
  const Bisector* best = nullptr;
  double largest = -1;
  for (const Bisector& c : diagram_.bisectors) {
    if (std::minmax(c.left, c.right) != std::minmax(a, b)) continue;
    // A new cell covers about half as much of the bisector's length as its generator is away from the two.
    const double length = std::max(compute_length(mesh_, c), std::numeric_limits<double>::min());
    const double ratio = distance(find_midpoint(mesh_, c), a) / length;
    if (ratio > largest) std::tie(largest, best) = std::tuple(ratio, &c);
  }
  if (added_.add(find_midpoint(mesh_, *best))) return;
  added_.add_best(best->points, [&](const SurfacePoint& p) { return distance(p, a); });
}

void DefectRepair::split_triple(BranchPointId branch) {
  const auto sorted_cells = [](const BranchPoint& b) {
    std::vector<GeneratorId> cells = b.generators;
    std::sort(cells.begin(), cells.end());
    return cells;
  };
  const auto cells = sorted_cells(diagram_.branch_points[branch]);
  std::vector<SurfacePoint> candidates;
  for (const BranchPoint& b : diagram_.branch_points) {
    if (sorted_cells(b) == cells) candidates.push_back(b.point);
  }
  added_.add_best(candidates, [&](const SurfacePoint& p) { return distance(p, cells[0]); });
}

/// Of the branch point and the bisectors between its cells, the point that is farthest from all generators. With
/// accurate distances it is nearly always close to the branch point. With inaccurate ones the branch point itself may
/// lie next to one of its generators, where another generator would not help.
void DefectRepair::split_polygon(BranchPointId branch) {
  const std::vector<GeneratorId>& cells = diagram_.branch_points[branch].generators;
  const auto among = [&](GeneratorId g) { return std::find(cells.begin(), cells.end(), g) != cells.end(); };
  std::vector<SurfacePoint> candidates{diagram_.branch_points[branch].point};
  for (const Bisector& b : diagram_.bisectors) {
    if (among(b.left) && among(b.right)) candidates.insert(candidates.end(), b.points.begin(), b.points.end());
  }
  added_.add_best(candidates, [&](const SurfacePoint& p) { return added_.clearance(p); });
}

/// The vertex of the cell that is farthest from its generator; without such a vertex, the farthest point of the cell's
/// bisectors.
void DefectRepair::add_farthest(GeneratorId g) {
  std::vector<SurfacePoint> candidates;
  for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
    const VertexId v(i);
    if (diagram_.vertex_label[v] == g) candidates.push_back(vertex_point(mesh_, v));
  }
  const auto vertex_distance = [&](const SurfacePoint& p) { return diagram_.vertex_distance[vertex(mesh_, p)]; };
  if (added_.add_best(candidates, vertex_distance)) return;
  candidates.clear();
  for (const Bisector& b : diagram_.bisectors) {
    if (b.left == g || b.right == g) candidates.insert(candidates.end(), b.points.begin(), b.points.end());
  }
  added_.add_best(candidates, [&](const SurfacePoint& p) { return distance(p, g); });
}

}  // namespace gvd
