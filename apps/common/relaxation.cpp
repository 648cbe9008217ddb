// The start of a relaxation: its density, and generators that are fixed, on creases and boundaries, or free.
//
// Sampled generators keep their number: each one that is placed on a curve takes the place of the nearest sample.
// Listed generators stay where they are; those on creases are kept there. Generators on curves are as far apart as
// evenly spread ones, or farther, so that enough are left for the faces: kFeatureShare. A density is a number for each
// vertex or face, out of the curvature, a list, or a property of the input.

#include "common/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/mesh.hpp"
#include "gvd/read_soup.hpp"
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
    for (const SurfacePoint& p : points) order_.push_back({position(mesh, p), order_.size(), false});
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

/// Appends the points of `added` that coincide with no earlier point.
void append_different(const Mesh& mesh, const Placed& added, Placed& placed) {
  std::vector<SurfacePoint> all = placed.points;
  all.insert(all.end(), added.points.begin(), added.points.end());
  const std::vector<std::int32_t> first = find_coincident(mesh, all);
  const std::size_t before = placed.points.size();
  for (std::size_t i = before; i < all.size(); ++i) {
    if (std::cmp_equal(first[i], i)) append(placed, all[i], added.freedom[i - before]);
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

[[noreturn]] void refuse_density(const std::string& message) { throw Error(ErrorCode::unreadable_input, message); }

/// The value of each vertex of the mesh. The midpoint of a split edge, which the file does not know, takes the mean.
std::vector<double> to_vertices(const CheckedMesh& input, const std::vector<double>& values) {
  std::vector<double> of_mesh;
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const std::int32_t v : input.input_vertex) {
    of_mesh.push_back(v < 0 ? mean : values[v]);
  }
  return of_mesh;
}

std::int64_t least_polygons(const CheckedMesh& input) {
  return 1 + *std::max_element(input.input_polygon.begin(), input.input_polygon.end());
}

bool lost_polygons(const CheckedMesh& input) {
  return input.defects.count(DefectKind::degenerate_faces) + input.defects.count(DefectKind::duplicate_faces) +
             input.defects.count(DefectKind::dropped_components) >
         0;
}

Density make_density(const CheckedMesh& input, const SoupProperty& property, const std::string& name) {
  try {
    if (property.of_vertices) return make_vertex_density(input.mesh, to_vertices(input, property.values));
    std::vector<double> of_faces;
    for (const std::int32_t p : input.input_polygon) of_faces.push_back(property.values[p]);
    return make_face_density(input.mesh, of_faces);
  } catch (const Error& error) {
    throw Error(error.code(), name + ": " + error.what(), error.element());
  }
}

/// Refuses a property that some polygons lack: strips of triangles have none.
void check_count(const CheckedMesh& input, const SoupProperty& property, const std::string& name) {
  if (property.of_vertices || std::ssize(property.values) >= least_polygons(input)) return;
  refuse_density(fmt::format("{}: {} for {}", name, counted(std::ssize(property.values), "number", "numbers"),
                             counted(least_polygons(input), "polygon", "polygons")));
}

/// Whether a list has a number for each vertex of the input or for each of its polygons.
SoupProperty assign(const CheckedMesh& input, std::vector<double> values, const std::string& name) {
  const auto count = std::ssize(values);
  if (count == std::ssize(input.mesh_vertex)) return {true, std::move(values)};
  const std::int64_t polygons = least_polygons(input);
  if (count == polygons || (count > polygons && lost_polygons(input))) return {false, std::move(values)};
  refuse_density(fmt::format("{}: {}; give one for each vertex ({}) or each face ({})", name,
                             counted(count, "number", "numbers"), input.mesh_vertex.size(), polygons));
}

/// The density that the options ask for. Throws Error where there is neither a file nor a property of that name, where
/// a number is missing or too much, and where one is not above 0.
Density read_density(const CheckedMesh& input, const std::string& path, const ConstraintOptions& options) {
  const std::string& name = options.density;
  if (name.empty()) return {};
  if (name == "curvature") return make_curvature_density(input.mesh, {options.gradation});
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored)) {
    return make_density(input, assign(input, read_numbers(name), name), name);
  }
  std::optional<SoupProperty> property = path == "-" ? std::nullopt : read_soup_property(path, name);
  if (property) {
    const std::string title = fmt::format("{}: property {}", path, name);
    check_count(input, *property, title);
    return make_density(input, *property, title);
  }
  refuse_density(fmt::format("--density {}: there is no such file, and {} has no such property", name,
                             path == "-" ? "standard input" : path));
}

/// Finds the creases, with the boundary where that is asked for, or preferred and possible.
void find_curves(const Mesh& mesh, const ConstraintOptions& options, bool listed, ConstrainedStart& start) {
  const double angle = options.features.value_or(180);
  start.corner_distance = kCornerDistance * even_spacing(compute_area(mesh), std::ssize(start.points));
  const bool prefers = options.prefers_boundary && !options.keep_boundary && !listed;
  start.creases = find_creases(mesh, {angle, options.keep_boundary || prefers});
  if (!prefers || start.creases.empty()) return;
  const Placed least = place_on_creases(mesh, start.creases, mesh.bbox_diagonal(), start.corner_distance);
  if (exceeds_share(least, start.points.size())) start.creases = find_creases(mesh, {angle, false});
}

}  // namespace

ConstrainedStart constrain_start(const CheckedMesh& input, std::vector<SurfacePoint> points,
                                 const ConstraintOptions& options, const Options& run) {
  const bool listed = run.generators.are_listed();
  ConstrainedStart start{std::move(points), {}, {}, 0, read_density(input, run.input.path, options)};
  find_curves(input.mesh, options, listed, start);
  const bool asks = options.features || options.keep_boundary || !options.fixed.empty();
  if (!asks && start.creases.empty()) return start;
  Placed placed = all_of(read_fixed(input, options.fixed), Freedom::fixed);
  if (listed) {
    append_listed(input.mesh, start, placed);
  } else {
    append_sampled(input.mesh, start, placed);
  }
  start.points = std::move(placed.points);
  start.freedom = std::move(placed.freedom);
  return start;
}

std::string describe_freedom(const std::vector<Freedom>& freedom) {
  const auto count = [&](Freedom kind) { return std::count(freedom.begin(), freedom.end(), kind); };
  return fmt::format("generators: {} fixed, {} on creases, {} free", count(Freedom::fixed), count(Freedom::on_crease),
                     count(Freedom::free));
}

LloydOptions make_lloyd_options(LloydOptions options, const ConstrainedStart& start, const ComputeOptions& compute) {
  options.freedom = start.freedom;
  options.creases = start.creases;
  options.density = start.density;
  options.diagram = make_diagram_options(compute);
  return options;
}

const char* name_of(LloydStop stop) {
  constexpr std::array<const char*, 5> kNames{"centroids", "energy", "no descent", "iterations", "time limit"};
  return kNames[static_cast<std::size_t>(stop)];
}

void report_constraints(nlohmann::ordered_json& options, const ConstraintOptions& constraints) {
  using Json = nlohmann::ordered_json;
  options["fixed"] = constraints.fixed.empty() ? Json() : Json(constraints.fixed);
  options["features"] = constraints.features ? Json(*constraints.features) : Json();
  options["keep_boundary"] = constraints.keep_boundary;
  options["density"] = constraints.density.empty() ? Json() : Json(constraints.density);
  options["gradation"] = constraints.gradation;
}

}  // namespace gvd::app
