// The search for generators that were added in vain.
//
// Leaving out one added generator, or putting one in the place of two, is tried on a part of the mesh first. What
// leaves no defect there is decided on the whole one, by the caller. One in the place of two is tried only if few
// defects remain without the two; candidates for it are the points that would repair these. Every change leaves one
// generator less, so the search ends; it also ends where the faces and generators of all its diagrams exceed a bound.

#include "base/least.hpp"
#include "repair/repair_steps.hpp"

namespace gvd {
namespace {

/// The most defects that two generators may leave for one in their place to be tried. Pairs that were replaced in
/// trials left one to three.
constexpr std::size_t kMostDefects = 4;

/// Changes in one place that pass on a part and fail on the whole mesh, before the next place is tried.
constexpr int kMostRefusals = 3;

/// Number of vertices of a part that are candidates, in the cells with defects. With twice as many the search took half
/// as long again, and left the elephant of docs/notes/remesh-bench.md with as many generators.
constexpr std::int32_t kVertexCandidates = 60;

class FewerGenerators {
 public:
  using Accept = std::function<bool(const std::vector<SurfacePoint>&)>;
  FewerGenerators(const Mesh& mesh, const Diagram& diagram, std::size_t given, const DiagramOptions& options,
                  const Accept& accept)
      : mesh_(mesh), diagram_(diagram), given_(given), options_(options), accept_(accept) {}

  void search() {
    while (pass_over_added()) {
    }
  }

 private:
  /// Tries each added generator, from the last one on. False where nothing has changed.
  bool pass_over_added() {
    bool changed = false;
    for (std::size_t i = diagram_.generators.size(); i-- > given_;) {
      if (is_beyond_bounds(2)) return false;
      if (i >= diagram_.generators.size()) continue;
      const GeneratorId g(i);
      if (leave_out({g}) || (!is_beyond_bounds() && unite_with_nearest(g))) changed = true;
    }
    return changed;
  }

  bool unite_with_nearest(GeneratorId g) {
    const auto other = find_nearest_added(g);
    return other && leave_out({std::min(g, *other), std::max(g, *other)});
  }

  bool leave_out(const std::vector<GeneratorId>& removed) {
    const LocalDual local(mesh_, diagram_, removed, removed, options_);
    const auto without = compute(local, {});
    if (!without) return false;
    if (without->defects.empty()) return accept(removed, {});
    return removed.size() > 1 && without->defects.size() <= kMostDefects && replace(removed, local, *without);
  }

  bool replace(const std::vector<GeneratorId>& removed, const LocalDual& local, const LocalDual::Result& without) {
    int refusals = 0;
    for (const SurfacePoint& candidate : list_candidates(local, without)) {
      if (is_beyond_bounds() || refusals == kMostRefusals) break;
      const auto with = compute(local, {candidate});
      if (!with || !with->defects.empty()) continue;
      if (accept(removed, {candidate})) return true;
      ++refusals;
    }
    return false;
  }

  std::optional<LocalDual::Result> compute(const LocalDual& local, const std::vector<SurfacePoint>& added) {
    // A part has as many generators for its faces as the whole.
    searched_ += local.part().size() * whole_size() / std::size_t(mesh_.face_count());
    return local.compute(added);
  }

  bool accept(const std::vector<GeneratorId>& removed, const std::vector<SurfacePoint>& added) {
    searched_ += whole_size();
    std::vector<SurfacePoint> generators;
    for (const Cell& cell : diagram_.cells) {
      const GeneratorId g = cell.generator;
      if (std::binary_search(removed.begin(), removed.end(), g)) continue;
      generators.push_back(diagram_.generators[g.index()]);
    }
    generators.insert(generators.end(), added.begin(), added.end());
    return accept_(generators);
  }

  /// Points of the whole mesh, the likeliest ones first.
  std::vector<SurfacePoint> list_candidates(const LocalDual& local, const LocalDual::Result& without) const {
    const Mesh& part = local.part().mesh();
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
    for (SurfacePoint& point : points) point = local.part().to_whole(point);
    return points;
  }

  /// The added generator that is nearest in space: along the surface it would cost a propagation.
  std::optional<GeneratorId> find_nearest_added(GeneratorId g) const {
    Least<std::optional<GeneratorId>> nearest;
    const Vec3 at = position(mesh_, diagram_.generators[g.index()]);
    for (std::size_t i = given_; i < diagram_.generators.size(); ++i) {
      const double distance = (position(mesh_, diagram_.generators[i]) - at).norm();
      if (i != g.index()) nearest.offer(distance, GeneratorId(i));
    }
    return nearest.value;
  }

  std::size_t whole_size() const { return mesh_.face_count() + diagram_.generators.size(); }
  /// Whether all diagrams so far exceed the bounds, or these bounds times `factor`.
  bool is_beyond_bounds(std::size_t factor = 1) const {
    return searched_ > factor * std::min(kSearchedElements, kSearchedMeshes * whole_size());
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::size_t given_;
  const DiagramOptions& options_;
  const Accept& accept_;
  std::size_t searched_ = 0;  // faces and generators in all diagrams so far
};

}  // namespace

void search_fewer_generators(const Mesh& mesh, const Diagram& diagram, std::size_t given, const DiagramOptions& options,
                             const std::function<bool(const std::vector<SurfacePoint>&)>& accept) {
  FewerGenerators(mesh, diagram, given, options, accept).search();
}

}  // namespace gvd
