// New generators for the defects of a dual.
//
// Each kind of defect has a repair of its own: the table in the header. A repair lists candidates and adds the one that
// is farthest from the generators concerned, so that new generators spread and the rounds end. A call repairs at most
// one defect of each cell, because a repair often removes the cell's other defects too. Repairs near those just added
// are computed on a part of the mesh, which saves rounds on all of it.

#include "repair/propose_generators.hpp"

#include <limits>
#include <set>
#include <utility>
#include <variant>

#include "base/least.hpp"
#include "diagram/bisector_length.hpp"
#include "diagram/cell_parts.hpp"
#include "repair/added_generators.hpp"
#include "repair/local_dual.hpp"

namespace gvd {
namespace {

/// The number of cells around a loop. The dual needs three, so that its edges have different ends; two may be discs
/// already.
constexpr int kPartsOfDual = 3, kFewestParts = 2;

}  // namespace

SurfacePoint find_midpoint(const Mesh& mesh, const Bisector& bisector) {
  const double half = 0.5 * compute_length(mesh, bisector);
  double sum = 0;
  for (std::size_t i = 1; i < bisector.points.size(); ++i) {
    const double step = (position(mesh, bisector.points[i]) - position(mesh, bisector.points[i - 1])).norm();
    if (sum + step >= half) return bisector.points[half - sum < 0.5 * step ? i - 1 : i];
    sum += step;
  }
  return bisector.points.back();
}

/// The elements of a diagram by the cells that they touch, each list ascending. A repair looks only at the elements of
/// its own cells, because a surface of many components has many defects and many elements. Cost: O(n).
struct CellElements {
  CellElements(const Mesh& mesh, const Diagram& diagram)
      : vertices(diagram.generators.size()),
        bisectors(diagram.generators.size()),
        branch_points(diagram.generators.size()) {
    for (const VertexId v : mesh.vertices()) {
      if (const GeneratorId g = diagram.vertex_label[v]; g.valid()) vertices[g].push_back(v);
    }
    for (const BisectorId b : diagram.bisectors.ids()) {
      const auto [left, right] = std::pair(diagram.bisectors[b].left, diagram.bisectors[b].right);
      bisectors[left].push_back(b);
      if (right != left) bisectors[right].push_back(b);
    }
    for (const BranchPointId b : diagram.branch_points.ids()) {
      for (const GeneratorId g : diagram.branch_points[b].generators) {
        if (branch_points[g].empty() || branch_points[g].back() != b) branch_points[g].push_back(b);
      }
    }
  }

  IdVector<GeneratorId, std::vector<VertexId>> vertices;  // of the cell's label
  IdVector<GeneratorId, std::vector<BisectorId>> bisectors;
  IdVector<GeneratorId, std::vector<BranchPointId>> branch_points;
};

class DefectRepair {
 public:
  /// All three must outlive the repair.
  DefectRepair(const Mesh& mesh, const Diagram& diagram, AddedGenerators& added)
      : mesh_(mesh), diagram_(diagram), added_(added) {}

  void repair(const DualDefect& defect) {
    switch (defect.property) {
      case DualProperty::component_reached:
        return add_to_component(defect.component);
      case DualProperty::cell_is_disc:
        return split_loop(defect.cells[0], kPartsOfDual);
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

  /// Adds generators so that a loop of the cell, round a tip or not contractible, passes through `parts` cells.
  void split_loop(GeneratorId g, int parts) {
    const std::size_t before = added_.size();
    std::vector<SurfacePoint> ring = rings().find(g);
    ring.resize(std::min(ring.size(), std::size_t(parts - 1)));
    for (const SurfacePoint& p : ring) added_.add(p);
    if (added_.size() > before) return;
    if (cut()) {
      for (const SurfacePoint& p : loops_->find(g, parts)) added_.add(p);
    }
    if (added_.size() == before) add_farthest(g);
  }

  /// Adds points that may divide the cell: opposite ones, those that halve a loop, and vertices, from the farthest one
  /// to the generator, evenly by their number.
  void divide(GeneratorId g) {
    if (cut()) {
      for (const SurfacePoint& p : find_opposite_points(mesh_, diagram_, g, loops_->borders(g))) added_.add(p);
    }
    split_loop(g, kFewestParts);
    std::vector<VertexId> vertices = elements().vertices[g];
    std::ranges::stable_sort(vertices, std::greater(), [&](VertexId v) { return diagram_.vertex_distance[v]; });
    const std::size_t step = 1 + vertices.size() / std::max<std::size_t>(1, added_.room());
    for (std::size_t i = 0; i < vertices.size(); i += step) added_.add(vertex_point(mesh_, vertices[i]));
  }

  /// The tip at which the defect can't be repaired, because the surface round it is too narrow.
  std::optional<NarrowTip> find_narrow_tip(const DualDefect& defect) {
    if (defect.property != DualProperty::cell_is_disc) return std::nullopt;
    return rings().find_narrow_tip(defect.cells[0]);
  }

 private:
  void add_to_component(std::int32_t component) {
    if (first_face_.empty()) {
      const auto& of = added_.component();
      for (const FaceId f : mesh_.faces()) {
        if (of[f] == std::ssize(first_face_)) first_face_.push_back(f);
      }
    }
    added_.add(vertex_point(mesh_, mesh_.vertices(first_face_[component])[0]));
  }

  const CellElements& elements() {
    if (!elements_) elements_.emplace(mesh_, diagram_);
    return *elements_;
  }

  const TipRings& rings() {
    if (!rings_) rings_.emplace(mesh_, diagram_);
    return *rings_;
  }

  /// Prepares the loops of cells. False where cutting along the bisectors gives no manifold mesh: two edges would have
  /// the same ends.
  bool cut() {
    if (loops_ || !can_cut_) return can_cut_;
    auto cut = try_to_cut_faces(mesh_, diagram_);
    can_cut_ = std::holds_alternative<CutMesh>(cut);
    if (can_cut_) loops_.emplace(mesh_, diagram_, std::get<CutMesh>(std::move(cut)));
    return can_cut_;
  }

  /// The new generator takes over the boundary arc that is farthest from g, so that g keeps the others.
  void split_boundary_arcs(GeneratorId g) {
    if (arcs_.empty()) {
      arcs_.resize(diagram_.generators.size());
      for (BoundaryArc& arc : list_boundary_arcs(mesh_, diagram_)) arcs_[arc.cell].push_back(std::move(arc));
    }
    std::vector<SurfacePoint> candidates;
    for (const BoundaryArc& arc : arcs_[g]) {
      candidates.push_back(find_nearest_point(mesh_, arc, added_.position_of(g)));
    }
    added_.add_best(candidates, [&](const SurfacePoint& p) { return distance(p, g); });
  }

  void split_bisector(const Bisector& b) {
    const auto value = [&](const SurfacePoint& p) { return distance(p, b.left) + distance(p, b.right); };
    if (b.closed) {
      added_.add_best(b.points, value);
    } else {
      added_.add_best({b.points.front(), b.points.back()}, value);
    }
  }

  void split_pair(GeneratorId a, GeneratorId b) {
    Least<const Bisector*> best;
    for (const BisectorId id : elements().bisectors[a]) {
      const Bisector& c = diagram_.bisectors[id];
      if (std::minmax(c.left, c.right) != std::minmax(a, b)) continue;
      // A new cell covers about half as much of the bisector's length as its generator is away from the two.
      const double length = std::max(compute_length(mesh_, c), std::numeric_limits<double>::min());
      best.offer(-distance(find_midpoint(mesh_, c), a) / length, &c);
    }
    if (added_.add(find_midpoint(mesh_, *best.value))) return;
    added_.add_best(best.value->points, [&](const SurfacePoint& p) { return distance(p, a); });
  }

  void split_triple(BranchPointId branch) {
    const auto sorted_cells = [](const BranchPoint& b) {
      std::vector<GeneratorId> cells = b.generators;
      std::sort(cells.begin(), cells.end());
      return cells;
    };
    const auto cells = sorted_cells(diagram_.branch_points[branch]);
    std::vector<SurfacePoint> candidates;
    for (const BranchPointId id : elements().branch_points[cells[0]]) {
      const BranchPoint& b = diagram_.branch_points[id];
      if (sorted_cells(b) == cells) candidates.push_back(b.point);
    }
    added_.add_best(candidates, [&](const SurfacePoint& p) { return distance(p, cells[0]); });
  }

  /// Adds the point of the branch point and of the bisectors between its cells that is farthest from all generators.
  /// With accurate distances it is nearly always close to the branch point. With inaccurate ones the branch point
  /// itself may lie next to one of its generators, where another generator would not help.
  void split_polygon(BranchPointId branch) {
    const std::vector<GeneratorId>& cells = diagram_.branch_points[branch].generators;
    const auto among = [&](GeneratorId g) { return std::find(cells.begin(), cells.end(), g) != cells.end(); };
    std::vector<SurfacePoint> candidates{diagram_.branch_points[branch].point};
    std::set<BisectorId> between;
    for (const GeneratorId g : cells) {
      for (const BisectorId id : elements().bisectors[g]) {
        if (among(diagram_.bisectors[id].left) && among(diagram_.bisectors[id].right)) between.insert(id);
      }
    }
    for (const BisectorId id : between) append_points(diagram_.bisectors[id], candidates);
    added_.add_best(candidates, [&](const SurfacePoint& p) { return added_.clearance(p); });
  }

  /// Adds the vertex of the cell that is farthest from its generator; without such a vertex, the farthest point of the
  /// cell's bisectors.
  void add_farthest(GeneratorId g) {
    std::vector<SurfacePoint> candidates;
    for (const VertexId v : elements().vertices[g]) candidates.push_back(vertex_point(mesh_, v));
    const auto vertex_distance = [&](const SurfacePoint& p) { return diagram_.vertex_distance[vertex(mesh_, p)]; };
    if (added_.add_best(candidates, vertex_distance)) return;
    candidates.clear();
    for (const BisectorId id : elements().bisectors[g]) append_points(diagram_.bisectors[id], candidates);
    added_.add_best(candidates, [&](const SurfacePoint& p) { return distance(p, g); });
  }

  static void append_points(const Bisector& bisector, std::vector<SurfacePoint>& points) {
    points.insert(points.end(), bisector.points.begin(), bisector.points.end());
  }

  /// Euclidean, from a generator of the diagram.
  double distance(const SurfacePoint& point, GeneratorId g) const {
    return (position(mesh_, point) - added_.position_of(g)).norm();
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  AddedGenerators& added_;
  std::optional<TipRings> rings_;
  std::optional<CellLoops> loops_;
  bool can_cut_ = true;  // the mesh can be cut along the bisectors, as far as is known
  std::optional<CellElements> elements_;
  IdVector<GeneratorId, std::vector<BoundaryArc>> arcs_;  // of each cell, once one of them needs its own
  std::vector<FaceId> first_face_;                        // of each component, once one of them needs it
};

namespace {

bool any_set(const CellFlags& flags, const std::vector<GeneratorId>& cells) {
  return std::any_of(cells.begin(), cells.end(), [&](GeneratorId g) { return flags[g] != 0; });
}

/// Whether this call has repaired a defect of the same cells already. A cell with too few neighbours also waits for the
/// repairs of its neighbours.
bool is_repaired(const CellFlags& repaired, const Diagram& diagram, const DualDefect& defect) {
  return any_set(repaired, defect.cells) || (defect.property == DualProperty::enough_neighbours &&
                                             any_set(repaired, diagram.cells[defect.cells[0]].neighbours));
}

/// A part with more than one in so many of the mesh's faces takes as long as a round on the whole mesh, which repairs
/// all places at once.
constexpr std::size_t kFacesPerPartFace = 4;

/// Repairs that take more rounds are left to rounds on the whole mesh, which are counted and end.
constexpr int kMostRounds = 8;

/// The cells in the faces of the points, ascending.
std::vector<GeneratorId> list_cells_around(const Mesh& mesh, const Diagram& diagram,
                                           const std::vector<SurfacePoint>& points) {
  std::vector<GeneratorId> cells;
  for (const SurfacePoint& point : points) {
    for (const FaceId f : faces_around(mesh, point)) {
      for_each_cell_part(diagram, f, [&](const FacePart& part) { cells.push_back(part.generator); });
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// The points of one round on the part, as points of the whole mesh; none if nothing is left to repair.
std::vector<SurfacePoint> propose_in_part(const LocalDual& local, const LocalDual::Result& result,
                                          std::size_t max_count, const Progress& progress) {
  if (result.defects.empty() || result.defects.front().property == DualProperty::not_flipped) return {};
  ProposedGenerators proposed =
      propose_generators(local.part().mesh, result.diagram, result.defects, max_count, progress);
  if (proposed.narrow) return {};
  for (SurfacePoint& point : proposed.points) point = local.part().to_whole(point);
  return std::move(proposed.points);
}

}  // namespace

ProposedGenerators propose_generators(const Mesh& mesh, const Diagram& diagram, const std::vector<DualDefect>& defects,
                                      std::size_t max_count, const Progress& progress) {
  ProposedGenerators proposed;
  AddedGenerators added(mesh, diagram.generators, max_count);
  DefectRepair repair(mesh, diagram, added);
  CellFlags repaired(diagram.generators.size(), 0);
  for (const DualDefect& defect : defects) {
    report_progress(progress, "repair", double(&defect - defects.data()) / double(defects.size()));
    if (added.is_full()) break;
    if (is_repaired(repaired, diagram, defect)) continue;
    const std::size_t before = added.size();
    proposed.narrow = repair.find_narrow_tip(defect);
    if (proposed.narrow) return proposed;
    repair.repair(defect);
    if (added.size() == before) continue;
    for (const GeneratorId g : defect.cells) repaired[g] = 1;
  }
  proposed.points = added.take();
  return proposed;
}

DiscCandidates::DiscCandidates(const Mesh& mesh, const Diagram& diagram, std::size_t count)
    : added_(mesh, diagram.generators, count), repair_(std::make_unique<DefectRepair>(mesh, diagram, added_)) {}

DiscCandidates::~DiscCandidates() = default;

std::vector<SurfacePoint> DiscCandidates::list(GeneratorId cell) {
  repair_->divide(cell);
  return added_.take();
}

NearbyGenerators propose_nearby(const Mesh& mesh, const Diagram& diagram, const std::vector<SurfacePoint>& added,
                                std::size_t max_count, const DiagramOptions& options) {
  const LocalDual local(mesh, diagram, list_cells_around(mesh, diagram, added), {}, options);
  if (kFacesPerPartFace * local.part().whole_face.size() > std::size_t(mesh.face_count())) return {};
  NearbyGenerators nearby;
  std::vector<SurfacePoint> all = added;
  for (int round = 0; round < kMostRounds && nearby.points.size() < max_count; ++round) {
    const auto result = local.compute(all);
    if (!result) break;
    nearby.events += result->diagram.report.propagation_events;
    const auto more = propose_in_part(local, *result, max_count - nearby.points.size(), options.progress);
    if (more.empty()) break;
    all.insert(all.end(), more.begin(), more.end());
    nearby.points.insert(nearby.points.end(), more.begin(), more.end());
  }
  return nearby;
}

}  // namespace gvd
