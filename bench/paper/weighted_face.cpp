#include "weighted_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/barycentric.hpp"
#include "diagram/envelope/equidistant_points.hpp"

namespace gvd::paper {
namespace {

/// Distances to a branch point may differ by this fraction of themselves: half of the digits, to which touching rays
/// determine it.
constexpr double kEquidistant = 1e-7;
/// A branch point may lie this far outside of the face, in barycentric coordinates.
constexpr double kOutside = 1e-9;

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

double WeightedFace::distance(GeneratorId g, const Vec2& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& group : sources_) {
    if (group.front().generator != g) continue;
    for (const FaceSource& source : group) least = std::min(least, source.distance(p));
  }
  return least;
}

bool WeightedFace::is_nearest_to(const std::array<GeneratorId, 3>& three, const Vec2& p) const {
  const auto [least, most] = std::minmax({distance(three[0], p), distance(three[1], p), distance(three[2], p)});
  if (!(most - least <= kEquidistant * most)) return false;
  for (const auto& group : sources_) {
    if (distance(group.front().generator, p) < least * (1 - kEquidistant)) return false;
  }
  return true;
}

std::vector<Bary> WeightedFace::find_branch_points(const std::array<GeneratorId, 3>& three) const {
  std::array<const std::vector<FaceSource>*, 3> groups{};
  for (const auto& group : sources_) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (group.front().generator == three[i]) groups[i] = &group;
    }
  }
  std::vector<Bary> found;
  if (groups[0] == nullptr || groups[1] == nullptr || groups[2] == nullptr) return found;
  std::vector<Vec2> points;
  append_equidistant_points(*groups[0], *groups[1], *groups[2], points);
  for (const Vec2& p : points) {
    const Bary bary = layout_.bary(p);
    if (*std::min_element(bary.begin(), bary.end()) < -kOutside || !is_nearest_to(three, p)) continue;
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
    const auto points = find_branch_points({before.generator, middle.generator, after.generator});
    if (points.empty()) continue;
    middle.points.push_back(points.front());
    before.points.push_back(points.front());
    after.points.insert(after.points.begin(), points.front());
    cut.polygons.push_back(std::move(middle));
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
  }
  return false;
}

/// Closes a run between two of one generator, and joins these; whether there was one.
bool WeightedFace::contract_bump(std::vector<BoundaryRun>& runs, Cut& cut) {
  const std::size_t n = runs.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    if (runs[before].generator != runs[after].generator) continue;
    const auto& points = runs[after].points;
    runs[before].points.insert(runs[before].points.end(), points.begin(), points.end());
    cut.polygons.push_back(std::move(runs[i]));
    for (const std::size_t gone : {std::max(i, after), std::min(i, after)}) {
      runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    return true;
  }
  return false;
}

/// Two runs share a segment; more of them meet in one point.
void WeightedFace::join_last(std::vector<BoundaryRun> runs, Cut& cut) const {
  if (runs.size() > 2) {
    Bary middle{0, 0, 0};
    for (const BoundaryRun& run : runs) {
      for (std::size_t i = 0; i < 3; ++i) middle[i] += run.points.front()[i] / static_cast<double>(runs.size());
    }
    for (BoundaryRun& run : runs) run.points.push_back(middle);
    cut.forced = true;
  }
  for (BoundaryRun& run : runs) cut.polygons.push_back(std::move(run));
}

WeightedFace::Cut WeightedFace::cut(std::vector<BoundaryRun> runs) const {
  Cut cut;
  while (runs.size() > 3 && (contract_triple(runs, cut) || contract_bump(runs, cut))) {
  }
  if (runs.size() == 3) {
    const auto points = find_branch_points({runs[0].generator, runs[1].generator, runs[2].generator});
    if (!points.empty()) {
      for (BoundaryRun& run : runs) cut.polygons.push_back({run.generator, std::move(run.points)});
      for (std::size_t i = cut.polygons.size() - 3; i < cut.polygons.size(); ++i) {
        cut.polygons[i].points.push_back(points.front());
      }
      return cut;
    }
  }
  join_last(std::move(runs), cut);
  return cut;
}

std::vector<BoundaryRun> make_runs(const std::vector<BoundaryCrossing>& crossings) {
  std::vector<BoundaryRun> runs;
  const std::size_t n = crossings.size();
  for (std::size_t i = 0; i < n; ++i) {
    const BoundaryCrossing &from = crossings[i], &to = crossings[(i + 1) % n];
    BoundaryRun run{from.next, {from.bary()}};
    const int corners = i + 1 < n ? to.corner - from.corner : to.corner + 3 - from.corner;
    for (int k = 1; k <= corners; ++k) {
      Bary corner{0, 0, 0};
      corner[static_cast<std::size_t>((from.corner + k) % 3)] = 1;
      run.points.push_back(corner);
    }
    run.points.push_back(to.bary());
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace gvd::paper
