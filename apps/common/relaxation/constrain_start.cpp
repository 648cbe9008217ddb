#include "common/relaxation/constrain_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "common/relaxation/read_density.hpp"
#include "common/steps/make_generators.hpp"
#include "gvd/counted.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_area.hpp"

namespace gvd::app {
namespace {

using Placed = FeatureGenerators;

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

bool is_listed(const Options& options) { return options.generators.vertices || !options.generators.file.empty(); }

/// The listed generators after those that are placed; each stays on its crease.
void append_listed(const Mesh& mesh, const ConstrainedStart& start, Placed& placed) {
  append_different(mesh, {start.points, freedoms_on_creases(mesh, start.creases, start.points)}, placed);
}

/// Generators on the creases, and the sampled ones that make room for all that are placed.
void append_sampled(const Mesh& mesh, const ConstrainedStart& start, Placed& placed) {
  const auto asked = std::ssize(start.points);
  if (!start.creases.empty()) {
    append_different(mesh, place_on_creases(mesh, start.creases, even_spacing(compute_area(mesh), asked)), placed);
  }
  if (std::ssize(placed.points) > asked) {
    throw Error(ErrorCode::precondition, fmt::format("{} asked for, and {} fixed or on features; ask for more with -n",
                                                     counted(asked, "generator is", "generators are"),
                                                     counted(std::ssize(placed.points), "is", "are")));
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

}  // namespace

ConstrainedStart make_start(Run& run, const CheckedMesh& input, const ConstraintOptions& options) {
  const bool has_creases = options.features || options.keep_boundary;
  ConstrainedStart start{make_generators(run, input), {}, {}, read_density(run, input, options)};
  if (!has_creases && options.fixed.empty()) return start;
  if (has_creases) start.creases = find_creases(input.mesh, {options.features.value_or(180), options.keep_boundary});
  Placed placed = all_of(read_fixed(input, options.fixed), Freedom::fixed);
  if (is_listed(run.options())) {
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
