// The start of a relaxation: generators that are fixed, on creases and boundaries, or free.
//
// Sampled generators keep their number: each one that is placed on a curve takes the place of the nearest sample, and
// so the others stay evenly spread. Listed generators stay where they are; those on creases are kept there. Generators
// on curves are as far apart as evenly spread ones, or farther, so that enough are left for the faces: kFeatureShare.
// Invariant: no generator that is placed or kept coincides with one before it. Cost: a search along x for each
// generator that is placed.
#include "gvd/constrained_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

#include "base/least.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// Largest share of the generators on creases, where corners and closed creases do not need more.
constexpr double kFeatureShare = 0.8;

bool exceeds_share(const FeatureGenerators& placed, std::size_t asked) {
  return static_cast<double>(placed.points.size()) > kFeatureShare * static_cast<double>(asked);
}

/// Factor of their spacing from one attempt to the next.
constexpr double kWiderSpacing = 1.1;

/// Least distance of turns of a crease, relative to the spacing of evenly spread generators.
constexpr double kCornerDistance = 0.5;

/// Listed generators this near to a crease are on it, as a fraction of the bounding box's diagonal: the rounding of six
/// digits. The remesher adds no generator nearer than a tenth of it to another one, so a corner that such a point
/// misses would stay empty.
constexpr double kListPrecision = 1e-5;

/// Removes points one by one, always the nearest to a given place that is left, of equals the one met first.
class NearestRemover {
 public:
  NearestRemover(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 at = position(mesh, points[i]);
      left_.emplace(std::pair(at.x(), i), at);
    }
  }

  /// Looks on both sides along x, as far as a nearer point may lie.
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

  /// Of `points`, those that are left, in their order.
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

/// The listed generators after those that are placed; each stays on its crease.
void append_listed(const Mesh& mesh, const ConstrainedStart& start, FeatureGenerators& placed) {
  const auto points = snap_to_creases(mesh, start.creases, start.points, kListPrecision * mesh.bbox_diagonal());
  append_different(mesh, {points, freedoms_on_creases(mesh, start.creases, points)}, placed);
}

/// A curve of length l has at least l / spacing - 1.5 generators between its ends: the quotient is rounded, and each
/// part but the last one ends at a generator.
constexpr double kLostToRounding = 1.5;

/// Whether the generators that creases of this length in all have at least are too many. Creases may be longer than the
/// spacing by many orders of magnitude, so that their generators would not fit into memory.
bool surely_exceeds_share(double length, double spacing, const ConstrainedStart& start) {
  const double least = length / spacing - kLostToRounding * double(start.creases.size());
  return least > kFeatureShare * double(start.points.size());
}

/// Generators on the creases as far apart as evenly spread ones, or farther, so that they are no more than
/// kFeatureShare of all.
FeatureGenerators place_features(const Mesh& mesh, const ConstrainedStart& start) {
  double spacing = even_spacing(compute_area(mesh), std::ssize(start.points)), length = 0;
  for (const EdgeId e : start.creases) length += mesh.length(e);
  while (surely_exceeds_share(length, spacing, start) && spacing < mesh.bbox_diagonal()) spacing *= kWiderSpacing;
  FeatureGenerators placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  while (exceeds_share(placed, start.points.size()) && spacing < mesh.bbox_diagonal()) {
    spacing *= kWiderSpacing;
    placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  }
  return placed;
}

/// Generators on the creases, and the sampled ones that make room for all that are placed.
void append_sampled(const Mesh& mesh, const ConstrainedStart& start, FeatureGenerators& placed) {
  const auto asked = std::ssize(start.points);
  if (!start.creases.empty()) append_different(mesh, place_features(mesh, start), placed);
  if (std::ssize(placed.points) > asked) {
    throw Error(
        ErrorCode::precondition,
        fmt::format("{} asked for, and {} fixed or on features; ask for more generators",
                    counted(asked, "generator is", "generators are"), counted(std::ssize(placed.points), "is", "are")));
  }
  NearestRemover remover(mesh, start.points);
  for (const SurfacePoint& p : placed.points) remover.remove_nearest(position(mesh, p));
  append_different(mesh, all_of(remover.rest(start.points), Freedom::free), placed);
}

/// Finds the creases, with the boundary where that is asked for, or preferred and possible.
void find_curves(const Mesh& mesh, const StartOptions& options, ConstrainedStart& start) {
  const double angle = options.crease_angle.value_or(180);
  start.corner_distance = kCornerDistance * even_spacing(compute_area(mesh), std::ssize(start.points));
  const bool prefers = options.prefers_boundary && !options.keep_boundary && !options.are_listed;
  start.creases = find_creases(mesh, {angle, options.keep_boundary || prefers});
  if (!prefers || start.creases.empty()) return;
  const FeatureGenerators least = place_on_creases(mesh, start.creases, mesh.bbox_diagonal(), start.corner_distance);
  if (exceeds_share(least, start.points.size())) start.creases = find_creases(mesh, {angle, false});
}

}  // namespace

ConstrainedStart constrain_start(const Mesh& mesh, std::vector<SurfacePoint> points, const StartOptions& options) {
  ConstrainedStart start{std::move(points), {}, {}, 0};
  find_curves(mesh, options, start);
  const bool asks = options.crease_angle || options.keep_boundary || !options.fixed.empty();
  if (!asks && start.creases.empty()) return start;
  FeatureGenerators placed = all_of(options.fixed, Freedom::fixed);
  if (options.are_listed) {
    append_listed(mesh, start, placed);
  } else {
    append_sampled(mesh, start, placed);
  }
  start.points = std::move(placed.points);
  start.freedom = std::move(placed.freedom);
  return start;
}

}  // namespace gvd
