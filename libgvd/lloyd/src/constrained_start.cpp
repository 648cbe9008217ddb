// Prepares the start of a relaxation: fixed generators, generators on creases and boundaries, and free ones.
//
// The number of sampled generators does not change: each generator placed on a curve replaces the nearest sample, so
// that the other samples stay evenly spread. Listed generators stay where they are, and on creases they are kept there.
// Generators on curves are as far apart as in an even triangulation, or farther, so that enough are left for the faces
// (most_on_features).
// Invariant: no generator that is placed or kept coincides with an earlier one.
// Cost: a search along x for each generator that is placed.
#include "gvd/constrained_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "base/least.hpp"
#include "chosen_curves.hpp"
#include "close_curves.hpp"
#include "crease_generators.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "gvd/vec.hpp"
#include "mesh/creases.hpp"
#include "mesh/find_coincident.hpp"

namespace gvd {
namespace {

/// The step whose progress is reported.
constexpr const char* kPlacing = "placing generators";

/// Removes points one by one, each time the remaining point nearest to a given place. Among equally near points, the
/// point found first is removed.
class NearestRemover {
 public:
  NearestRemover(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 at = position(mesh, points[i]);
      left_.emplace(std::pair(at.x(), i), at);
    }
  }

  /// Searches on both sides along x, as far as a nearer point may lie.
  void remove_nearest(const Vec3& place) {
    const auto middle = left_.lower_bound({place.x(), 0});
    Least<decltype(left_)::iterator> nearest{left_.end()};
    const auto offer = [&](auto item) { nearest.offer((item->second - place).norm(), item); };
    for (auto item = middle; item != left_.end() && item->first.first - place.x() < nearest.rank; ++item) offer(item);
    for (auto item = middle; item != left_.begin() && place.x() - std::prev(item)->first.first < nearest.rank; --item) {
      offer(std::prev(item));
    }
    if (nearest.value != left_.end()) left_.erase(nearest.value);
  }

  /// The remaining ones of `points`, in their order.
  std::vector<SurfacePoint> rest(const std::vector<SurfacePoint>& points) const {
    std::vector<std::size_t> indices;
    for (const auto& [key, at] : left_) indices.push_back(key.second);
    std::sort(indices.begin(), indices.end());
    std::vector<SurfacePoint> kept;
    for (const std::size_t i : indices) kept.push_back(points[i]);
    return kept;
  }

 private:
  std::map<std::pair<double, std::size_t>, Vec3> left_;  ///< by x and index
};

void append(FeatureGenerators& placed, const SurfacePoint& point, Freedom freedom) {
  placed.points.push_back(point);
  placed.freedom.push_back(freedom);
}

/// Appends the points of `added` that coincide with no earlier point.
void append_different(const Mesh& mesh, const FeatureGenerators& added, FeatureGenerators& placed) {
  std::vector<SurfacePoint> all = placed.points;
  all.insert(all.end(), added.points.begin(), added.points.end());
  const std::vector<std::int32_t> first = find_coincident(mesh, all);
  const std::size_t before = placed.points.size();
  for (std::size_t i = before; i < all.size(); ++i) {
    if (std::cmp_equal(first[i], i)) append(placed, all[i], added.freedom[i - before]);
  }
}

FeatureGenerators all_of(const std::vector<SurfacePoint>& points, Freedom freedom) {
  return {points, std::vector<Freedom>(points.size(), freedom)};
}

/// Listed generators this near to a crease count as on it, as a fraction of the bounding box's diagonal. It is the
/// rounding of six digits. The remesher adds no generator nearer than a tenth of this to another one, so a corner that
/// such a point misses would stay empty.
constexpr double kListPrecision = 1e-5;

/// Appends the listed generators after the placed ones; each stays on its crease.
void append_listed(const Mesh& mesh, const ConstrainedStart& start, FeatureGenerators& placed) {
  const auto points = snap_to_creases(mesh, start.creases, start.points, kListPrecision * mesh.bbox_diagonal());
  append_different(mesh, {points, freedoms_on_creases(mesh, start.creases, points)}, placed);
}

/// Factor by which the spacing grows from one attempt to the next.
constexpr double kWiderSpacing = 1.1;

/// If an even triangulation had more than so many times all vertices on the boundary, the surface is thinner than the
/// spacing, or its boundary is rough: there is no such triangulation, and the boundary gets kFeatureShare.
constexpr double kMostOnBoundary = 1.5;

/// How many generators may be placed on the creases: kFeatureShare of all. If all creases are boundaries, as many as an
/// even triangulation has there if that is more: on a small piece of a plane, this is most of its vertices. With fewer,
/// the cells of other generators would meet the boundary, and a remesh would add the missing ones.
std::size_t most_on_features(const Mesh& mesh, const ConstrainedStart& start, double spacing) {
  const double asked = double(start.points.size());
  const bool is_boundary = std::ranges::all_of(start.creases, [&](EdgeId e) { return mesh.is_boundary(e); });
  const double even = is_boundary ? total_length(mesh, start.creases) / spacing : 0;
  const double most = even > kMostOnBoundary * asked ? 0 : even;
  return static_cast<std::size_t>(std::clamp(most, kFeatureShare * asked, asked));
}

/// Places generators on the creases as far apart as in an even triangulation, or farther, so that they are at most
/// most_on_features.
FeatureGenerators place_features(const Mesh& mesh, const ConstrainedStart& start, double spacing) {
  const std::size_t most = most_on_features(mesh, start, spacing);
  while (surely_exceeds(mesh, start.creases, spacing, double(most)) && spacing < mesh.bbox_diagonal()) {
    spacing *= kWiderSpacing;
  }
  FeatureGenerators placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  while (placed.points.size() > most && spacing < mesh.bbox_diagonal()) {
    spacing *= kWiderSpacing;
    placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  }
  return placed;
}

/// Removes samples to make up for the generators that the remesh is expected to add.
void leave_room(const Mesh& mesh, const ConstrainedStart& start, double spacing, NearestRemover& remover) {
  const std::vector<Vec3> expected = expect_opposite_generators(mesh, start.creases, spacing, start.corner_distance);
  const auto most = static_cast<std::size_t>(kOppositeShare * static_cast<double>(start.points.size()));
  for (std::size_t i = 0; i < std::min(most, expected.size()); ++i) remover.remove_nearest(expected[i]);
}

/// Appends generators on the creases and the remaining samples, after removing a sample for each generator that is
/// placed. Returns an error where more are placed than were sampled.
std::optional<Error> append_sampled(const Mesh& mesh, const ConstrainedStart& start, const StartOptions& options,
                                    double spacing, FeatureGenerators& placed) {
  const auto asked = std::ssize(start.points);
  if (!start.creases.empty()) append_different(mesh, place_features(mesh, start, spacing), placed);
  if (std::ssize(placed.points) > asked) {
    return Error(
        ErrorCode::precondition,
        fmt::format("{} requested, but {} fixed or on features; ask for more generators",
                    counted(asked, "generator is", "generators are"), counted(std::ssize(placed.points), "is", "are")));
  }
  NearestRemover remover(mesh, start.points);
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    report_progress(options.progress, kPlacing, double(i) / double(placed.points.size()));
    remover.remove_nearest(position(mesh, placed.points[i]));
  }
  const auto is_inner = [&](EdgeId e) { return !mesh.is_boundary(e); };
  if (options.leaves_room && std::ranges::any_of(start.creases, is_inner)) leave_room(mesh, start, spacing, remover);
  report_progress(options.progress, kPlacing, 1);
  append_different(mesh, all_of(remover.rest(start.points), Freedom::free), placed);
  return std::nullopt;
}

}  // namespace

OrError<ConstrainedStart> constrain_start(const Mesh& mesh, std::vector<SurfacePoint> points,
                                          const StartOptions& options) {
  ConstrainedStart start;
  start.points = std::move(points);
  const double spacing = choose_curves(mesh, options, start);
  const bool asks_for_creases = options.crease_angle && !options.prefers_creases;
  const bool asks = asks_for_creases || options.keep_boundary || !options.fixed.empty();
  if (!asks && start.creases.empty()) return start;
  FeatureGenerators placed = all_of(options.fixed, Freedom::fixed);
  if (options.are_listed) {
    append_listed(mesh, start, placed);
  } else if (auto error = append_sampled(mesh, start, options, spacing, placed)) {
    return *std::move(error);
  }
  start.points = std::move(placed.points);
  start.freedom = std::move(placed.freedom);
  return start;
}

}  // namespace gvd
