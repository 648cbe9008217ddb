// Chooses the creases and boundary loops that generators follow.
//
// Before preferred curves are chosen, the generators that they need are counted, including the generators that a remesh
// has to add where two curves are closer to each other than their generators. Boundary loops that are too short and
// creases that are noise are left out. If the creases need too many generators, none is followed, and the start
// suggests a number of generators with which they would be.
#include "chosen_curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "close_curves.hpp"
#include "crease_generators.hpp"
#include "gvd/vec.hpp"
#include "mesh/creases.hpp"

namespace gvd {
namespace {

/// The least distance between turns of a crease, relative to the spacing of evenly spread generators.
constexpr double kCornerDistance = 0.5;

std::vector<EdgeId> join_edges(const std::vector<EdgeId>& a, const std::vector<EdgeId>& b) {
  std::vector<EdgeId> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

/// The side h of the triangles in an even triangulation with `count` vertices. By Euler's formula, a mesh of F faces
/// and B boundary edges has F / 2 + B / 2 vertices, apart from a constant for its topology: count = 2 area / (sqrt(3)
/// h^2) + boundary / (2 h).
double spacing_beside(double area, double boundary, std::int64_t count) {
  const double n = static_cast<double>(count), half = boundary / 4;
  return (half + std::sqrt(half * half + n * 2 * area / std::numbers::sqrt3)) / n;
}

/// The smallest number of generators that can follow the creases: one at each corner, and three on a closed crease.
std::size_t count_least(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing) {
  return place_on_creases(mesh, creases, mesh.bbox_diagonal(), kCornerDistance * spacing).points.size();
}

/// The least share of the creases' length in clear groups, because noise also forms some closed rings. The share is .7
/// or more on CAD models, and at most .2 on scans and other smooth models.
constexpr double kClearShare = 0.5;

/// The least length of a clear group of creases for each of its ends and turns, in spacings. Groups of CAD models have
/// 4 or more, and groups of scans mostly 2 or less.
constexpr double kLengthPerEnd = 3;

/// The same for each end if faces are larger than the spacing. Each edge of such a mesh is crisp, and the creases of
/// CAD models have no end, or one in 40 spacings.
constexpr double kLengthPerEndOfFaces = 20;

/// The least mean crispness of a clear group of creases. It is .99 to 1 on CAD models with sharp edges, more than .8 on
/// those with bevels up to a twentieth of the spacing, and .5 to .93 on scans and on models with rounded edges, where
/// following creases gains little distance and costs shape.
constexpr double kLeastCrispness = 0.8;

/// The least number of generators with which the share allowed on curves suffices for these curves.
std::int64_t find_enough(const Mesh& mesh, const std::vector<EdgeId>& curves, double boundary, std::int64_t count) {
  while (true) {
    const double spacing = spacing_beside(compute_area(mesh), boundary, count);
    const double need = std::ceil(static_cast<double>(count_least(mesh, curves, spacing)) / kFeatureShare);
    if (!(need > static_cast<double>(count))) return count;
    count = static_cast<std::int64_t>(need);
  }
}

/// Leaves out boundary loops that would take too many generators. `others`: creases that are followed in any case.
void choose_loops(const Mesh& mesh, double spacing, const std::vector<EdgeId>& others, std::vector<EdgeId>& boundary,
                  ConstrainedStart& start) {
  const auto fits = [&](const std::vector<EdgeId>& loops) {
    return !exceeds_share(count_least(mesh, join_edges(loops, others), spacing), start.points.size());
  };
  const std::vector<CreaseGroup> loops = group_creases(mesh, boundary);
  start.loops = std::ssize(loops);
  if (boundary.empty() || fits(boundary)) return;
  start.enough_for_loops =
      find_enough(mesh, join_edges(boundary, others), total_length(mesh, boundary), std::ssize(start.points));
  boundary = keep_long(loops, spacing);
  if (!fits(boundary)) boundary.clear();
  const auto is_followed = [&](const CreaseGroup& loop) { return !boundary.empty() && loop.is_long(spacing); };
  start.unfollowed_loops = start.loops - std::ranges::count_if(loops, is_followed);
}

/// The number of generators needed on curves divided by the number allowed there, for `count` generators in all.
double find_excess(const Mesh& mesh, const std::vector<EdgeId>& curves, double boundary, std::int64_t count) {
  const double spacing = spacing_beside(compute_area(mesh), boundary, count), asked = static_cast<double>(count);
  if (surely_exceeds(mesh, curves, spacing, kFeatureShare * asked)) return kInfinity;
  const double corner_distance = kCornerDistance * spacing;
  const auto opposite = static_cast<double>(expect_opposite_generators(mesh, curves, spacing, corner_distance).size());
  const double all = static_cast<double>(place_on_creases(mesh, curves, spacing, corner_distance).points.size());
  return std::max((all + opposite) / (kFeatureShare * asked), opposite / (kOppositeShare * asked));
}

/// The largest number of generators to suggest for creases, relative to the requested number: users who ask for 100 do
/// not want 100,000.
constexpr double kMostAdvised = 10;

/// Number of attempts to find a number to suggest. If there are few corners, the first or second attempt succeeds.
constexpr int kAdviceTrials = 6;

/// Finds a number of generators that can follow creases, at most kMostAdvised times the requested number; 0 if none is
/// found. Apart from corners, the number on curves grows with the square root of the number of all generators.
template <class Excess>
std::int64_t find_enough_for_creases(std::int64_t asked, double excess, const Excess& excess_of) {
  double count = static_cast<double>(asked);
  for (int trial = 0; trial < kAdviceTrials && excess > 1; ++trial) {
    count = std::ceil(count * excess * excess);
    if (!(count <= kMostAdvised * static_cast<double>(asked))) return 0;
    excess = excess_of(static_cast<std::int64_t>(count));
  }
  return excess > 1 ? 0 : static_cast<std::int64_t>(count);
}

/// Keeps the creases of the groups that are clear: long, crisp, and with few ends and turns.
std::vector<EdgeId> keep_clear(const Mesh& mesh, const CreaseChains& chains, double spacing) {
  const CreaseNetwork network(mesh, chains.edges, kCornerDistance * spacing);
  IdVector<EdgeId, double> crispness(mesh.edge_count(), 0);
  for (std::size_t i = 0; i < chains.edges.size(); ++i) crispness[chains.edges[i]] = chains.crispness[i];
  const double per_end = spacing < mesh.mean_edge_length() ? kLengthPerEndOfFaces : kLengthPerEnd;
  std::vector<CreaseGroup> groups = group_creases(mesh, chains.edges);
  std::erase_if(groups, [&](const CreaseGroup& group) {
    double least = 0;
    for (const VertexId v : group.vertices) {
      if (!network.is_corner(v) || mesh.is_boundary(v)) continue;
      if (network.leaving(v).size() == 1) least += per_end * spacing;
      if (network.leaving(v).size() == 2) least += kLengthPerEnd * spacing;
    }
    double crisp = 0;  // length times crispness
    for (const EdgeId e : group.edges) crisp += mesh.length(e) * crispness[e];
    return group.length < least || crisp < kLeastCrispness * group.length;
  });
  return keep_long(groups, spacing);
}

/// Leaves out creases that are noise or rounded, or all creases if they would take too many generators.
void choose_creases(const Mesh& mesh, double spacing, const std::vector<EdgeId>& boundary, const CreaseChains& chains,
                    std::vector<EdgeId>& creases, ConstrainedStart& start) {
  creases = keep_clear(mesh, chains, spacing);
  if (total_length(mesh, creases) < kClearShare * total_length(mesh, chains.edges)) creases.clear();
  if (creases.empty()) return;
  const std::vector<EdgeId> curves = join_edges(boundary, creases);
  const auto excess_of = [&, border = total_length(mesh, boundary)](std::int64_t count) {
    return find_excess(mesh, curves, border, count);
  };
  const double excess = excess_of(std::ssize(start.points));
  if (excess <= 1) return;
  creases.clear();
  start.leaves_creases = true;
  start.enough_for_creases = find_enough_for_creases(std::ssize(start.points), excess, excess_of);
}

/// A curve of length l has at least l / spacing - 1.5 generators between its ends, because the quotient is rounded and
/// each part except the last ends at a generator.
constexpr double kLostToRounding = 1.5;

}  // namespace

bool surely_exceeds(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing, double most) {
  const double least = total_length(mesh, creases) / spacing - kLostToRounding * double(creases.size());
  return least > most;
}

double choose_curves(const Mesh& mesh, const StartOptions& options, ConstrainedStart& start) {
  const bool prefers_boundary = options.prefers_boundary && !options.keep_boundary && !options.are_listed;
  std::vector<EdgeId> boundary, creases;
  if (options.keep_boundary || prefers_boundary) boundary = find_creases(mesh, {180, true});
  const double spacing = spacing_beside(compute_area(mesh), total_length(mesh, boundary), std::ssize(start.points));
  start.corner_distance = kCornerDistance * spacing;
  CreaseChains chains;
  if (options.crease_angle) chains = find_crease_chains(mesh, *options.crease_angle, spacing);
  if (!options.prefers_creases) creases = chains.edges;
  if (prefers_boundary) choose_loops(mesh, spacing, creases, boundary, start);
  if (options.prefers_creases) choose_creases(mesh, spacing, boundary, chains, creases, start);
  start.creases = join_edges(boundary, creases);
  return spacing;
}

}  // namespace gvd
