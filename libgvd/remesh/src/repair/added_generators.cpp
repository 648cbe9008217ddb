// A list of new generators, each with a least distance from all others.
//
// Distances are Euclidean, except for points that are nearly the same in space: they may lie on the two banks of a slit
// or on two sheets that touch. For these, a search over the faces within the distance tells whether one connected part
// of the surface holds both. Where the distance is less than the surface's features, this agrees with the geodesic one.

#include "repair/added_generators.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/least.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/text.hpp"

namespace gvd {
bool are_near(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, double radius) {
  if (!((position(mesh, b) - position(mesh, a)).norm() <= radius)) return false;
  const std::vector<FaceId> goal = faces_around(mesh, b), reached = faces_within(mesh, a, radius);
  return std::find_first_of(reached.begin(), reached.end(), goal.begin(), goal.end()) != reached.end();
}

AddedGenerators::AddedGenerators(const Mesh& mesh, const std::vector<SurfacePoint>& existing, std::size_t max_count)
    : mesh_(mesh),
      spacing_(kMinAddedSpacing * mesh.bbox_diagonal()),
      max_count_(max_count),
      component_(compute_face_components(mesh)),
      of_component_(mesh.face_count()) {
  for (const SurfacePoint& g : existing) insert(g);
}

double AddedGenerators::clearance(const SurfacePoint& point) const {
  const Vec3 at = position(mesh_, point);
  double least = kInfinity;
  for (const GeneratorId i : of_component_[component_[point.face]]) {
    const double squared = (positions_[i] - at).squaredNorm();
    if (squared >= least) continue;
    if (squared > spacing_ * spacing_ || are_near(mesh_, point, all_[i], spacing_)) least = squared;
  }
  return std::sqrt(least);
}

namespace {

/// The last round with the most defects. Few generators have few defects, and the first ones added make more.
RepairHistory::const_iterator find_peak(const RepairHistory& history) {
  auto peak = history.begin();
  for (auto round = history.begin(); round != history.end(); ++round) {
    if (round->second >= peak->second) peak = round;
  }
  return peak;
}

}  // namespace

std::optional<std::int64_t> estimate_added(const MeshSummary& mesh, std::size_t generators,
                                           const RepairHistory& history) {
  const auto [first_added, first_defects] = *find_peak(history);
  const auto [added, defects] = history.back();
  const std::int64_t least =
      mesh.boundary_loops > 0 ? 3 * std::max(mesh.components, mesh.boundary_loops) : std::int64_t{4} * mesh.components;
  const std::int64_t by_topology = added + least - std::int64_t(generators);
  const auto removed = double(first_defects) - double(defects);
  const std::int64_t by_trend =
      removed > 0 ? added + std::llround(double(defects) * double(added - first_added) / removed) : 0;
  const std::int64_t need = std::max(by_topology, by_trend);
  return need > added ? std::optional(need) : std::nullopt;
}

namespace {

/// Numbers of defects vary by chance, with the places of a round's generators. A count of independent events has its
/// square root as standard deviation, and the difference of two counts the square root of their sum. Chance exceeds two
/// standard deviations in one case of twenty.
constexpr double kChance = 2;

bool has_grown(std::size_t first, std::size_t last) {
  return double(last) - double(first) > kChance * std::sqrt(double(first) + double(last));
}

}  // namespace

std::string advise_at_limit(const MeshSummary& mesh, std::size_t generators, const RepairHistory& history,
                            bool is_max_added, std::int64_t usual) {
  const std::size_t first = history.front().second, most = find_peak(history)->second, last = history.back().second;
  const std::int64_t added = history.back().first;
  std::string advice;
  if (added > 0) {
    advice = fmt::format(", and {} became {}{}", counted(std::int64_t(first), "defect", "defects"),
                         most > first && most > last ? fmt::format("{}, then ", most) : "", last);
  }
  // The first added generators often make defects, so that a few of them say nothing about more.
  const bool are_few = is_max_added && added < usual;
  const auto need = estimate_added(mesh, generators, history);
  if (need) {
    advice += fmt::format("; about {} are likely to be needed", *need);
  } else if (are_few) {
    advice += fmt::format("; by default, {} may be added", usual);
  } else if (has_grown(first, last)) {
    return advice +
           "; so far, added generators make it worse, so look at the surface there: it may be thin, folded "
           "or far too coarse";
  }
  return advice + ": give more or other ones" + (is_max_added ? ", or raise \1max_added\2" : "");
}

std::vector<SurfacePoint> propose_farthest(const Mesh& mesh, const Diagram& diagram, std::size_t count) {
  IdVector<GeneratorId, Least<VertexId>> farthest(diagram.generators.size());
  for (const VertexId v : mesh.vertices()) {
    if (diagram.vertex_label[v].valid()) farthest[diagram.vertex_label[v]].offer(-diagram.vertex_distance[v], v);
  }
  std::vector<std::pair<double, VertexId>> order;
  for (const auto& [vertex, rank] : farthest) {
    if (vertex.valid()) order.emplace_back(rank, vertex);
  }
  std::sort(order.begin(), order.end());
  AddedGenerators added(mesh, diagram.generators, count);
  for (const auto& [rank, vertex] : order) added.add(vertex_point(mesh, vertex));
  return added.take();
}

}  // namespace gvd
