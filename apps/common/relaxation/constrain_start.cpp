#include "common/relaxation/constrain_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "common/relaxation/read_density.hpp"
#include "common/steps/make_generators.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Placed = FeatureGenerators;

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

/// Removes points one by one, always the nearest to a given place that is left.
class NearestRemover {
 public:
  NearestRemover(const Mesh& mesh, const std::vector<SurfacePoint>& points) : points_(points) {
    for (std::size_t i = 0; i < points.size(); ++i) order_.push_back({position(mesh, points[i]), i, false});
    std::sort(order_.begin(), order_.end(),
              [](const Item& a, const Item& b) { return std::pair(a.at.x(), a.index) < std::pair(b.at.x(), b.index); });
  }

  /// Looks on both sides along x, as far as a nearer point may lie.
  void remove_nearest(const Vec3& place) {
    const auto middle = std::lower_bound(order_.begin(), order_.end(), place.x(),
                                         [](const Item& item, double x) { return item.at.x() < x; });
    Item* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](Item& item) {
      const double distance = (item.at - place).norm();
      if (item.removed || !(distance < least)) return;
      least = distance;
      nearest = &item;
    };
    for (auto item = middle; item != order_.end() && item->at.x() - place.x() < least; ++item) offer(*item);
    for (auto item = middle; item != order_.begin() && place.x() - (item - 1)->at.x() < least; --item)
      offer(*(item - 1));
    if (nearest) nearest->removed = true;
  }

  std::vector<SurfacePoint> rest() const {
    std::vector<std::size_t> left;
    for (const Item& item : order_) {
      if (!item.removed) left.push_back(item.index);
    }
    std::sort(left.begin(), left.end());
    std::vector<SurfacePoint> points;
    for (const std::size_t i : left) points.push_back(points_[i]);
    return points;
  }

 private:
  struct Item {
    Vec3 at;
    std::size_t index;
    bool removed;
  };
  const std::vector<SurfacePoint>& points_;
  std::vector<Item> order_;  // by x
};

std::vector<SurfacePoint> read_fixed(const CheckedMesh& input, const std::string& file) {
  if (file.empty()) return {};
  ResolveOptions options;
  options.input_vertices = &input.mesh_vertex;
  return resolve_generators(input.mesh, read_generators(file), options).points;
}

void append(Placed& placed, const SurfacePoint& point, Freedom freedom) {
  placed.points.push_back(point);
  placed.freedom.push_back(freedom);
}

/// Those of `added` that coincide with no earlier point.
void append_different(const Mesh& mesh, const Placed& added, Placed& placed) {
  std::vector<SurfacePoint> all = placed.points;
  all.insert(all.end(), added.points.begin(), added.points.end());
  const std::vector<std::int32_t> first = find_coincident(mesh, all);
  const std::size_t before = placed.points.size();
  for (std::size_t i = before; i < all.size(); ++i) {
    if (first[i] == static_cast<std::int32_t>(i)) append(placed, all[i], added.freedom[i - before]);
  }
}

Placed all_of(const std::vector<SurfacePoint>& points, Freedom freedom) {
  return {points, std::vector<Freedom>(points.size(), freedom)};
}

/// The listed generators after those that are placed; each stays on its crease.
void append_listed(const Mesh& mesh, const ConstrainedStart& start, Placed& placed) {
  const auto points = snap_to_creases(mesh, start.creases, start.points, kListPrecision * mesh.bbox_diagonal());
  append_different(mesh, {points, freedoms_on_creases(mesh, start.creases, points)}, placed);
}

/// Generators on the creases as far apart as evenly spread ones, or farther, so that they are no more than
/// kFeatureShare of all.
Placed place_features(const Mesh& mesh, const ConstrainedStart& start) {
  double spacing = even_spacing(compute_area(mesh), std::ssize(start.points));
  Placed placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  while (exceeds_share(placed, start.points.size()) && spacing < mesh.bbox_diagonal()) {
    spacing *= kWiderSpacing;
    placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  }
  return placed;
}

/// Generators on the creases, and the sampled ones that make room for all that are placed.
void append_sampled(const Mesh& mesh, const ConstrainedStart& start, Placed& placed) {
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
  append_different(mesh, all_of(remover.rest(), Freedom::free), placed);
}

void note_freedoms(Console& console, const std::vector<Freedom>& freedom) {
  const auto count = [&](Freedom kind) { return std::count(freedom.begin(), freedom.end(), kind); };
  console.note(fmt::format("generators: {} fixed, {} on creases, {} free", count(Freedom::fixed),
                           count(Freedom::on_crease), count(Freedom::free)));
}

/// Finds the creases, with the boundary where that is asked for, or preferred and possible.
void find_curves(const Options& run, const Mesh& mesh, const ConstraintOptions& options, ConstrainedStart& start) {
  const double angle = options.features.value_or(180);
  start.corner_distance = kCornerDistance * even_spacing(compute_area(mesh), std::ssize(start.points));
  const bool prefers = options.prefers_boundary && !options.keep_boundary && !run.generators.are_listed();
  start.creases = find_creases(mesh, {angle, options.keep_boundary || prefers});
  if (!prefers || start.creases.empty()) return;
  const Placed least = place_on_creases(mesh, start.creases, mesh.bbox_diagonal(), start.corner_distance);
  if (exceeds_share(least, start.points.size())) start.creases = find_creases(mesh, {angle, false});
}

}  // namespace

ConstrainedStart make_start(Run& run, const CheckedMesh& input, const ConstraintOptions& options) {
  ConstrainedStart start{make_generators(run, input, options.count), {}, {}, 0, read_density(run, input, options)};
  find_curves(run.options(), input.mesh, options, start);
  const bool asks = options.features || options.keep_boundary || !options.fixed.empty();
  if (!asks && start.creases.empty()) return start;
  Placed placed = all_of(read_fixed(input, options.fixed), Freedom::fixed);
  if (run.options().generators.are_listed()) {
    append_listed(input.mesh, start, placed);
  } else {
    append_sampled(input.mesh, start, placed);
  }
  note_freedoms(run.console(), placed.freedom);
  start.points = std::move(placed.points);
  start.freedom = std::move(placed.freedom);
  return start;
}

}  // namespace gvd::app
