// A face, cut by the additively weighted Voronoi diagram of its sources with straight segments ([27] in the paper).
//
// The boundary of the face is a ring of runs, one for each maximal interval with one label. A run that three sources
// allow to end in an equally far point is closed there and leaves the ring; the ring shrinks until two runs are left.
// Where no rule applies the ends meet in the mean of the crossings, and the face counts as forced.
//
// The paper describes the usual cases: no crossing, two, or three with a branch point. Everything else is a face near
// which several cells are thin, and is ours. Where paths enter decides which runs of a generator belong together: a
// shortest path stays in its cell, so that the cell connects its two ends. Polygons need not be convex.
#include "weighted_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/barycentric.hpp"

namespace gvd::paper {
namespace {

/// Distances to a branch point may differ by this fraction of themselves: half of the digits, to which touching rays
/// determine it.
constexpr double kEquidistant = 1e-7;
/// A branch point may lie this far outside of the face, in barycentric coordinates.
constexpr double kOutside = 1e-9;

/// Paths may leave the face this far beside a run, in lengths of the side: where they graze its end, rounding decides.
constexpr double kBesideRun = 1e-6;

Bary clamp_to_face(Bary bary) {
  double sum = 0;
  for (double& b : bary) sum += b = std::max(b, 0.0);
  for (double& b : bary) b /= sum;
  return bary;
}

}  // namespace

WeightedFace::WeightedFace(const FaceLayout& layout, const std::vector<FaceSource>& sources) : layout_(layout) {
  std::vector<FaceSource> sorted = sources;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const FaceSource& a, const FaceSource& b) { return a.generator < b.generator; });
  for (const FaceSource& source : sorted) {
    if (sources_.empty() || sources_.back().front().generator != source.generator) sources_.emplace_back();
    sources_.back().push_back(source);
  }
}

/// The source of generator g with the shortest path to p; null without one.
const FaceSource* WeightedFace::nearest(GeneratorId g, const Vec2& p, double& distance) const {
  const FaceSource* best = nullptr;
  distance = kInfinity;
  for (const auto& group : sources_) {
    if (group.front().generator != g) continue;
    for (const FaceSource& source : group) {
      const double d = source.distance(p);
      if (d < distance) best = &source;
      distance = std::min(distance, d);
    }
  }
  return best;
}

/// Whether the run's generator has its shortest path to p enter the face through the run.
bool WeightedFace::enters_through(const BoundaryRun& run, const Vec2& p) const {
  double distance = 0;
  const FaceSource* source = nearest(run.generator, p, distance);
  if (source == nullptr) return false;
  const int corner = Mesh::corner(source->halfedge);
  double at = corner;
  if (!source->is_corner()) at += layout_.bary(source->entry(p))[(corner + 1) % 3];
  const auto contains = [&](double s) { return s > run.begin - kBesideRun && s < run.end + kBesideRun; };
  return contains(at) || contains(at + 3) || contains(at - 3);
}

/// Whether p is equally far from three runs' generators, no other one is nearer, and all paths enter through these
/// runs.
bool WeightedFace::is_branch_point(const Three& runs, const Vec2& p) const {
  std::array<double, 3> d{};
  for (std::size_t i = 0; i < 3; ++i) {
    nearest(runs[i]->generator, p, d[i]);
    if (!enters_through(*runs[i], p)) return false;
  }
  const auto [least, most] = std::minmax({d[0], d[1], d[2]});
  if (!(most - least <= kEquidistant * most)) return false;
  for (const auto& group : sources_) {
    double other = 0;
    nearest(group.front().generator, p, other);
    if (other < least * (1 - kEquidistant)) return false;
  }
  return true;
}

/// Points that are equally far from the three generators along straight lines. Runs of the same generators follow each
/// other again and again beside needles, so that what was found is kept.
const std::vector<Vec2>& WeightedFace::find_equidistant_points(const Three& runs) const {
  const std::array<GeneratorId, 3> generators{runs[0]->generator, runs[1]->generator, runs[2]->generator};
  const auto [entry, is_new] = equidistant_.try_emplace(generators);
  if (!is_new) return entry->second;
  std::array<std::span<const FaceSource>, 3> groups;
  for (const auto& group : sources_) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (group.front().generator == generators[i]) groups[i] = group;
    }
  }
  if (groups[0].empty() || groups[1].empty() || groups[2].empty()) return entry->second;
  return entry->second = search_.find(layout_, groups[0], groups[1], groups[2]);
}

/// The branch points of three runs in the face, moved onto its boundary where they lie outside by rounding.
std::vector<Bary> WeightedFace::find_branch_points(const Three& runs) const {
  std::vector<Bary> found;
  for (const Vec2& p : find_equidistant_points(runs)) {
    const Bary bary = layout_.bary(p);
    if (*std::min_element(bary.begin(), bary.end()) < -kOutside || !is_branch_point(runs, p)) continue;
    found.push_back(clamp_to_face(bary));
  }
  return found;
}

/// Ends the run in the middle of three at a branch point; whether there was one.
bool WeightedFace::contract_triple(std::vector<BoundaryRun>& runs, Cut& cut) const {
  const std::size_t n = runs.size();
  for (std::size_t i = 0; i < n; ++i) {
    BoundaryRun &before = runs[(i + n - 1) % n], &middle = runs[i], &after = runs[(i + 1) % n];
    if (before.generator == after.generator) continue;
    const auto points = find_branch_points({&before, &middle, &after});
    if (points.empty()) continue;
    middle.points.push_back(points.front());
    before.points.push_back(points.front());
    after.points.insert(after.points.begin(), points.front());
    cut.polygons.push_back(std::move(middle));
    runs.erase(runs.begin() + i);
    return true;
  }
  return false;
}

/// Whether the middle of a run is reached through another run of the same generator: the cell connects them.
bool WeightedFace::is_linked(const BoundaryRun& run, const BoundaryRun& other) const {
  const double middle = std::fmod(0.5 * (run.begin + run.end), 3);
  const int corner = std::min(static_cast<int>(middle), 2);
  return enters_through(other, layout_.at(bary_on_side(corner, middle - corner)));
}

/// Closes a run between two of one generator, and joins these; whether there was one. `linked`: only if the two are.
bool WeightedFace::contract_bump(std::vector<BoundaryRun>& runs, bool linked, Cut& cut) const {
  const std::size_t n = runs.size();
  for (std::size_t i = 0; i < n; ++i) {
    BoundaryRun &before = runs[(i + n - 1) % n], &after = runs[(i + 1) % n];
    if (before.generator != after.generator) continue;
    if (linked && !is_linked(before, after) && !is_linked(after, before)) continue;
    before.points.insert(before.points.end(), after.points.begin(), after.points.end());
    before.end = after.end < before.begin ? after.end + 3 : after.end;
    cut.polygons.push_back(std::move(runs[i]));
    const std::size_t gone = (i + 1) % n;
    runs.erase(runs.begin() + std::max(i, gone));
    runs.erase(runs.begin() + std::min(i, gone));
    return true;
  }
  return false;
}

/// Two runs share a segment; more of them meet in one point.
void WeightedFace::join_last(std::vector<BoundaryRun> runs, Cut& cut) const {
  if (runs.size() > 2) {
    Bary middle{0, 0, 0};
    for (const BoundaryRun& run : runs) {
      for (std::size_t i = 0; i < 3; ++i) middle[i] += run.points.front()[i] / double(runs.size());
    }
    for (BoundaryRun& run : runs) run.points.push_back(middle);
    cut.forced = true;
  }
  for (BoundaryRun& run : runs) cut.polygons.push_back(std::move(run));
}

WeightedFace::Cut WeightedFace::cut(std::vector<BoundaryRun> runs) const {
  Cut cut;
  while (runs.size() > 3 &&
         (contract_triple(runs, cut) || contract_bump(runs, true, cut) || contract_bump(runs, false, cut))) {
  }
  // Of three runs the first one ends, and the two others share the segment that is left.
  if (runs.size() == 3 && contract_triple(runs, cut)) {
    for (BoundaryRun& run : runs) cut.polygons.push_back(std::move(run));
    return cut;
  }
  join_last(std::move(runs), cut);
  return cut;
}

std::vector<BoundaryRun> make_runs(const std::vector<BoundaryCrossing>& crossings) {
  std::vector<BoundaryRun> runs;
  const std::size_t n = crossings.size();
  for (std::size_t i = 0; i < n; ++i) {
    const BoundaryCrossing &from = crossings[i], &to = crossings[(i + 1) % n];
    BoundaryRun run{from.next, {from.bary()}, from.corner + from.t, to.corner + to.t};
    if (i + 1 == n) run.end += 3;
    const int corners = i + 1 < n ? to.corner - from.corner : to.corner + 3 - from.corner;
    for (int k = 1; k <= corners; ++k) run.points.push_back(bary_on_side((from.corner + k) % 3, 0));
    run.points.push_back(to.bary());
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace gvd::paper
