// Changes that leave a dual right with fewer generators, tried on parts of the mesh.
//
// Without the generators that a change removes, a part has defects or none. Where it has few, a single point may take
// the place of two generators. Only its own cell repairs anything, so it has to be nearer to the place of each defect
// than the generators there. That leaves few candidates, which are tried in the order of how much nearer they are.
//
// Changes that are apart from each other are decided on together, because a diagram of the whole mesh costs as much as
// some ten parts, and the placement of all vertices comes with it.

#include "repair/local_changes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/least.hpp"
#include "repair/added_generators.hpp"
#include "repair/propose_generators.hpp"

namespace gvd {
namespace {

/// If two generators leave more defects than this, no point is tried in their place. The pairs that could be replaced
/// left one to three.
constexpr std::size_t kMostDefects = 4;

/// The work of a decision on the whole mesh, in diagrams. It is above 1 because all vertices are placed as well: with
/// 1, a search doubles the time of a bunny with 30 generators; with 2 it adds a fifth.
constexpr std::int64_t kWorkOfDecision = 2;

/// The number of vertices of a part that are candidates, in the cells with defects. With twice as many, the search
/// takes half as long again and leaves the elephant of docs/notes/remesh-bench.md with as many generators.
constexpr std::int32_t kVertexCandidates = 60;

/// The largest number of candidates that are tried in the place of two generators. On the elephant with 100 generators,
/// no candidate after the tenth succeeded.
constexpr std::size_t kMostCandidates = 10;

/// Rings of cells round a change in which trials have to be repeated: those of the parts of LocalDual.
constexpr int kNearRings = 2;

/// How far a point is from covering the place of a defect with its cell: the distance of the point from the place,
/// relative to the distance of the generators there. Below 1, the point's own cell covers the place. If there are
/// several places, the nearest counts.
class DefectReach {
 public:
  DefectReach(const Mesh& mesh, const Diagram& diagram, const DualDefect& defect)
      : mesh_(mesh), diagram_(diagram), cells_(defect.cells) {
    const bool any_side =
        defect.property == DualProperty::cell_is_disc || defect.property == DualProperty::enough_neighbours;
    const bool is_bisector =
        defect.property == DualProperty::one_bisector || defect.property == DualProperty::bisector_has_face;
    for (const Bisector& b : diagram.bisectors) {
      if (any_side && (has(b.left) || has(b.right))) places_.insert(places_.end(), b.points.begin(), b.points.end());
      if (is_bisector && has(b.left) && has(b.right)) places_.push_back(find_midpoint(mesh, b));
    }
    if (any_side || is_bisector) return;
    for (const BranchPoint& b : diagram.branch_points) {
      const auto shared =
          std::count_if(b.generators.begin(), b.generators.end(), [&](GeneratorId g) { return has(g); });
      if (shared >= std::ssize(cells_)) places_.push_back(b.point);
    }
  }

  double operator()(const SurfacePoint& point) const {
    const Vec3 at = position(mesh_, point);
    double least = kInfinity;
    for (const SurfacePoint& place : places_) {
      const Vec3 p = position(mesh_, place);
      least = std::min(least, (p - at).norm() / distance_from_cells(p));
    }
    return least;
  }

 private:
  bool has(GeneratorId g) const { return std::find(cells_.begin(), cells_.end(), g) != cells_.end(); }
  double distance_from_cells(const Vec3& p) const {
    double least = kInfinity;
    for (const GeneratorId g : cells_) {
      least = std::min(least, (position(mesh_, diagram_.generators[g.index()]) - p).norm());
    }
    return least;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  const std::vector<GeneratorId>& cells_;
  std::vector<SurfacePoint> places_;
};

/// The points whose cells reach the places of all defects, the nearest ones first.
std::vector<SurfacePoint> sort_by_reach(const Mesh& mesh, const LocalDual::Result& without,
                                        const std::vector<SurfacePoint>& points) {
  std::vector<double> reach(points.size(), 0);
  for (const DualDefect& defect : without.defects) {
    const DefectReach of_defect(mesh, without.diagram, defect);
    for (std::size_t i = 0; i < points.size(); ++i) reach[i] = std::max(reach[i], of_defect(points[i]));
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !(reach[i] < 1); });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return reach[a] < reach[b]; });
  std::vector<SurfacePoint> sorted;
  for (const std::size_t i : order) sorted.push_back(points[i]);
  return sorted;
}

}  // namespace

void LocalChanges::leave_out(GeneratorId g) {
  tried_[g] = 1;
  const LocalDual local(mesh_, diagram_, {g}, {g}, search_.diagram);
  const auto without = compute(local, {});
  if (without && without->defects.empty()) collect({g}, {});
}

void LocalChanges::unite(GeneratorId g, GeneratorId other) {
  tried_[g] = 1;
  const std::vector<GeneratorId> removed{std::min(g, other), std::max(g, other)};
  const LocalDual local(mesh_, diagram_, removed, removed, search_.diagram);
  const auto without = compute(local, {});
  if (!without || without->defects.size() > kMostDefects) return;
  if (without->defects.empty()) {
    const bool may_both_go = count() >= search_.least + removed.size();
    return may_both_go ? collect(removed, {}) : collect({g}, {});
  }
  // Loops of cells are sought in the part cut along its bisectors, which takes about as long as its diagram.
  if (search_.only == DualProperty::cell_is_disc) {
    events_ += std::ssize(without->defects) * without->diagram.report.propagation_events;
  }
  std::size_t trials = 0;
  for (const SurfacePoint& candidate : list_candidates(local, *without)) {
    if (is_over() || trials++ == kMostCandidates) return;
    if (std::find(refused_.begin(), refused_.end(), candidate) != refused_.end()) continue;
    const auto with = compute(local, {candidate});
    if (with && with->defects.empty()) return collect(removed, {candidate});
  }
}

/// Points of the whole mesh, the most promising ones first.
std::vector<SurfacePoint> LocalChanges::list_candidates(const LocalDual& local,
                                                        const LocalDual::Result& without) const {
  const Mesh& part = local.part().mesh;
  const Diagram& diagram = without.diagram;
  std::vector<SurfacePoint> points;
  CellFlags defective(diagram.cells.size(), 0);
  for (const DualDefect& defect : without.defects) {
    const auto proposed = propose_generators(part, diagram, {defect}, diagram.generators.size());
    points.insert(points.end(), proposed.points.begin(), proposed.points.end());
    for (const GeneratorId g : defect.cells) defective[g] = 1;
  }
  const auto is_defective = [&](GeneratorId g) { return g.valid() && defective[g] != 0; };
  for (const BranchPoint& b : diagram.branch_points) {
    if (std::any_of(b.generators.begin(), b.generators.end(), is_defective)) points.push_back(b.point);
  }
  const std::int32_t step = std::max(1, part.vertex_count() / kVertexCandidates);
  for (std::int32_t i = 0; i < part.vertex_count(); i += step) {
    if (is_defective(diagram.vertex_label[VertexId(i)])) points.push_back(vertex_point(part, VertexId(i)));
  }
  AddedGenerators spaced(part, diagram.generators, points.size());
  std::erase_if(points, [&](const SurfacePoint& point) { return !spaced.add(point); });
  std::vector<SurfacePoint> sorted = sort_by_reach(part, without, points);
  for (SurfacePoint& point : sorted) point = local.part().to_whole(point);
  return sorted;
}

std::optional<LocalDual::Result> LocalChanges::compute(const LocalDual& local, const std::vector<SurfacePoint>& added) {
  auto result = local.compute(added);
  if (result && search_.only) {
    std::erase_if(result->defects, [&](const DualDefect& defect) { return defect.property != *search_.only; });
  }
  // If the part can't tell, its work is estimated by its share of the mesh's faces.
  const auto share = double(local.part().whole_face.size()) / double(mesh_.face_count());
  events_ += result ? result->diagram.report.propagation_events
                    : std::int64_t(share * double(diagram_.report.propagation_events));
  return result;
}

void LocalChanges::collect(std::vector<GeneratorId> removed, std::vector<SurfacePoint> added) {
  const CellFlags in_rings = grow_rings(diagram_, removed, kNearRings);
  std::vector<GeneratorId> near;
  for (const Cell& cell : diagram_.cells) {
    if (in_rings[cell.generator]) near.push_back(cell.generator);
  }
  for (const GeneratorId g : near) near_change_[g] = 1;
  if (removed.size() > 1 && added.empty()) ++both_;
  collected_.push_back({std::move(removed), std::move(added), std::move(near)});
}

void LocalChanges::apply() {
  const std::vector<SurfacePoint> before = diagram_.generators;
  const std::vector<std::size_t> made = decide(before);
  CellFlags gone(before.size(), 0), tried;
  std::size_t added = 0;
  for (const std::size_t i : made) {
    for (const GeneratorId g : collected_[i].removed) gone[g] = 1;
    added += collected_[i].added.size();
    for (const GeneratorId g : collected_[i].near) tried_[g] = 0;
  }
  for (std::size_t g = 0; g < before.size(); ++g) {
    if (!gone[GeneratorId(g)]) tried.push_back(tried_[GeneratorId(g)]);
  }
  for (std::size_t i = 0; i < added; ++i) tried.push_back(0);
  tried_ = std::move(tried);
  near_change_ = CellFlags(tried_.size(), 0);
  collected_.clear();
  both_ = 0;
}

/// Decides on the collected changes, group by group. Returns those made. If a group fails, the next one is a quarter of
/// it; if it passes, the next one is twice as large.
std::vector<std::size_t> LocalChanges::decide(const std::vector<SurfacePoint>& before) {
  std::vector<std::size_t> made;
  std::size_t size = collected_.size();
  for (std::size_t begin = 0; begin < collected_.size() && !is_over();) {
    const std::size_t end = std::min(begin + size, collected_.size());
    std::vector<std::size_t> all = made;
    for (std::size_t i = begin; i < end; ++i) all.push_back(i);
    const bool passes = accept(before, all);
    if (passes) made = std::move(all);
    if (!passes && end - begin == 1) refuse(collected_[begin]);
    if (passes || end - begin == 1) begin = end;
    size = passes ? 2 * size : std::max(std::size_t{1}, (end - begin) / 4);
  }
  return made;
}

void LocalChanges::refuse(const Change& change) {
  if (change.added.empty()) return;
  refused_.push_back(change.added.front());
  for (const GeneratorId g : change.removed) tried_[g] = 0;
}

bool LocalChanges::accept(const std::vector<SurfacePoint>& before, const std::vector<std::size_t>& changes) {
  CellFlags gone(before.size(), 0);
  for (const std::size_t i : changes) {
    for (const GeneratorId g : collected_[i].removed) gone[g] = 1;
  }
  std::vector<SurfacePoint> generators;
  for (std::size_t g = 0; g < before.size(); ++g) {
    if (!gone[GeneratorId(g)]) generators.push_back(before[g]);
  }
  for (const std::size_t i : changes) {
    generators.insert(generators.end(), collected_[i].added.begin(), collected_[i].added.end());
  }
  const bool is_right = search_.accept(generators);
  // If the dual is not right, diagram_ is the one before, which has about as many generators and events.
  events_ += kWorkOfDecision * diagram_.report.propagation_events;
  return is_right;
}

}  // namespace gvd
