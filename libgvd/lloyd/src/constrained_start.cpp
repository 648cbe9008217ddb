// The start of a relaxation: generators that are fixed, on creases and boundaries, or free.
//
// Sampled generators keep their number: each one that is placed on a curve takes the place of the nearest sample, and
// so the others stay evenly spread. Listed generators stay where they are; those on creases are kept there. Generators
// on curves are as far apart as in an even triangulation, or farther, so that enough are left for the faces:
// kFeatureShare. Curves that are preferred are counted before they are chosen, with those generators that a remesh has
// to add where two curves are closer to each other than their generators.
// Invariant: no generator that is placed or kept coincides with one before it. Cost: a search along x for each
// generator that is placed.
#include "gvd/constrained_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

#include "base/least.hpp"
#include "crease_generators.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"
#include "gvd/vec.hpp"
#include "mesh/creases.hpp"
#include "mesh/find_coincident.hpp"

namespace gvd {
namespace {

/// Largest share of the generators on creases and boundaries, where corners and closed creases do not need more. A
/// closed surface with 27 small holes needs three generators on each. With .8, 80 of 100 were on holes, and the remesh
/// was 20.8 % of the diagonal away. Without any on holes it is 4.4 %, and with 150 generators 3.2 % (RMS .38) instead
/// of 3.7 % (RMS .78). With 200, 41 % of them suffice, and both are about as far away, with a seventh more vertices
/// where none is on a hole.
constexpr double kFeatureShare = 0.5;

/// The step whose progress is told.
constexpr const char* kPlacing = "placing generators";

bool exceeds_share(std::size_t placed, std::size_t asked) {
  return static_cast<double>(placed) > kFeatureShare * static_cast<double>(asked);
}

/// Least share of the creases that has to be in long groups (CreaseGroup): noise makes some closed rings, too. It is
/// .76 or more on those CAD models, and at most .25 on scans and other smooth models.
constexpr double kLongShare = 0.5;

/// Largest share of generators that a remesh is expected to add opposite others, for creases to be followed by default.
/// With .116 (plate 2000, rotor less) following creases improves distances, the least angle, and the share of faces
/// with an angle below 30 degrees (6.1 to 1.2 %). With .124 (rotor 500) it improves the distances, but the mean Q falls
/// from .808 to .797, and that share rises from 9.6 to 14.4 %. With .23 (plate 500) Q falls from .835 to .77.
constexpr double kOppositeShare = 0.12;

/// Two curves are close where their distance is below this, in spacings: a generator of one may be nearer to the middle
/// between two generators of the other than these are.
constexpr double kCloseCurves = 0.5;

/// Close points are also nearer to each other than this part of the way to the end of their curve. Where two curves
/// leave a corner, that is an angle below 45 degrees.
const double kLeastSine = std::sqrt(0.5);

/// Points of one curve are close to each other only where the way along the curve is longer than this, in spacings.
constexpr double kSameCourse = 1.5;

/// Samples of a curve for each spacing, where close curves are looked for.
constexpr double kSamplesPerSpacing = 4;

/// Most generators to advise for creases, by those asked for; users who ask for 100 do not want 100,000.
constexpr double kMostAdvised = 10;

/// Trials of a number to advise. Where corners are few, the first or second one fits.
constexpr int kAdviceTrials = 6;

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

std::vector<EdgeId> join_edges(const std::vector<EdgeId>& a, const std::vector<EdgeId>& b) {
  std::vector<EdgeId> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

/// Side of the triangles of an even triangulation with `count` vertices. By Euler's formula, a mesh of F faces and B
/// boundary edges has F / 2 + B / 2 vertices, but for its topology: count = 2 area / (sqrt(3) h^2) + boundary / (2 h).
double spacing_beside(double area, double boundary, std::int64_t count) {
  const double n = static_cast<double>(count), half = boundary / 4;
  return (half + std::sqrt(half * half + n * 2 * area / std::numbers::sqrt3)) / n;
}

/// Curves that sampled generators may follow, for one number of them.
struct Spaced {
  const Mesh& mesh;
  double spacing = 0;  ///< of an even triangulation, mesh units
  double corner_distance() const { return kCornerDistance * spacing; }

  std::size_t count(const std::vector<EdgeId>& creases, double at) const {
    return place_on_creases(mesh, creases, at, corner_distance()).points.size();
  }
  /// The fewest generators that can follow the creases: on corners, and three on a closed crease.
  std::size_t least(const std::vector<EdgeId>& creases) const { return count(creases, mesh.bbox_diagonal()); }
};

/// Where a remesh has to add generators on curves: along curves that are closer to each other than their generators.
/// The relaxation moves generators of two such curves to gaps of each other, and each then needs one more opposite.
/// Measured: 116 expected and 112 added on the plate with 500, 232 and 222 with 2000; 63 and 86 on the rotor with 500,
/// 116 and 116 with 2000; 14 and 16 on the fandisk with 100. Some more are added at bends and beside free generators.
class CloseCurves {
 public:
  CloseCurves(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing)
      : mesh_(mesh), spacing_(spacing), curves_(trace_creases(mesh, creases, kCornerDistance * spacing)) {
    for (const CreaseCurve& curve : curves_) lengths_.push_back(total_length(mesh, curve.edges));
    for (std::size_t c = 0; c < curves_.size(); ++c) add_samples(c);
    for (std::size_t i = 0; i < samples_.size(); ++i) in_box_[box(samples_[i].at)].push_back(i);
  }

  /// A place for each generator that is expected. Cost: O(k log k) for k samples, as long as few are in each other's
  /// reach.
  std::vector<Vec3> expected() const {
    std::vector<Vec3> places;
    double length = 0;
    for (const Sample& sample : samples_) {
      if (has_close(sample)) length += sample.length;
      if (length < spacing_) continue;
      places.push_back(sample.at);
      length -= spacing_;
    }
    return places;
  }

 private:
  struct Sample {
    Vec3 at;
    std::size_t curve;
    double along;   // the curve, mesh units
    double to_end;  // of the curve, infinite where it is closed
    double length;  // of its part of the curve
  };
  using Box = std::array<std::int64_t, 3>;

  double reach() const { return kCloseCurves * spacing_; }

  Box box(const Vec3& at) const {
    Box box{};
    for (int i = 0; i < 3; ++i) box[i] = static_cast<std::int64_t>(std::floor(at[i] / reach()));
    return box;
  }

  void add_samples(std::size_t c) {
    const CreaseCurve& curve = curves_[c];
    const double parts = std::max(1.0, std::round(kSamplesPerSpacing * lengths_[c] / spacing_));
    std::vector<double> at;
    for (double k = 0; k < parts; ++k) at.push_back(lengths_[c] * (k + 0.5) / parts);
    const std::vector<SurfacePoint> points = points_on_curve(mesh_, curve, at);
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double to_end = curve.closed ? kInfinity : std::min(at[k], lengths_[c] - at[k]);
      samples_.push_back({position(mesh_, points[k]), c, at[k], to_end, lengths_[c] / parts});
    }
  }

  bool has_close(const Sample& sample) const {
    const auto [x, y, z] = box(sample.at);
    for (std::int64_t i = x - 1; i <= x + 1; ++i) {
      for (std::int64_t j = y - 1; j <= y + 1; ++j) {
        for (std::int64_t k = z - 1; k <= z + 1; ++k) {
          if (const auto near = in_box_.find({i, j, k}); near != in_box_.end() && any_close(sample, near->second)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  bool any_close(const Sample& sample, const std::vector<std::size_t>& others) const {
    const double within = std::min(reach(), kLeastSine * sample.to_end);
    return std::any_of(others.begin(), others.end(), [&](std::size_t i) {
      const Sample& other = samples_[i];
      return (other.at - sample.at).norm() < within && !is_same_course(sample, other);
    });
  }

  bool is_same_course(const Sample& a, const Sample& b) const {
    if (a.curve != b.curve) return false;
    const double way = std::abs(a.along - b.along);
    const bool closed = curves_[a.curve].closed;
    return (closed ? std::min(way, lengths_[a.curve] - way) : way) < kSameCourse * spacing_;
  }

  const Mesh& mesh_;
  double spacing_;
  std::vector<CreaseCurve> curves_;
  std::vector<double> lengths_;  // of the curves
  std::vector<Sample> samples_;
  std::map<Box, std::vector<std::size_t>> in_box_;  // samples, boxes as long as the reach
};

/// A curve of length l has at least l / spacing - 1.5 generators between its ends: the quotient is rounded, and each
/// part but the last one ends at a generator.
constexpr double kLostToRounding = 1.5;

/// Whether the generators that these creases have at least are too many. Creases may be longer than the spacing by many
/// orders of magnitude, so that their generators would not fit into memory.
bool surely_exceeds_share(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing, std::size_t asked) {
  const double least = total_length(mesh, creases) / spacing - kLostToRounding * double(creases.size());
  return least > kFeatureShare * double(asked);
}

/// Generators on the creases as far apart as in an even triangulation, or farther, so that they are no more than
/// kFeatureShare of all.
FeatureGenerators place_features(const Mesh& mesh, const ConstrainedStart& start, double spacing) {
  while (surely_exceeds_share(mesh, start.creases, spacing, start.points.size()) && spacing < mesh.bbox_diagonal()) {
    spacing *= kWiderSpacing;
  }
  FeatureGenerators placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  while (exceeds_share(placed.points.size(), start.points.size()) && spacing < mesh.bbox_diagonal()) {
    spacing *= kWiderSpacing;
    placed = place_on_creases(mesh, start.creases, spacing, start.corner_distance);
  }
  return placed;
}

/// Removes the samples that would make a mesh of too many vertices, together with those that the remesh adds.
void leave_room(const Mesh& mesh, const ConstrainedStart& start, double spacing, NearestRemover& remover) {
  const std::vector<Vec3> expected = CloseCurves(mesh, start.creases, spacing).expected();
  const auto most = static_cast<std::size_t>(kOppositeShare * static_cast<double>(start.points.size()));
  for (std::size_t i = 0; i < std::min(most, expected.size()); ++i) remover.remove_nearest(expected[i]);
}

/// Generators on the creases, and the sampled ones that make room for all that are placed.
void append_sampled(const Mesh& mesh, const ConstrainedStart& start, const StartOptions& options,
                    FeatureGenerators& placed) {
  const auto asked = std::ssize(start.points);
  const double spacing = start.corner_distance / kCornerDistance;
  if (!start.creases.empty()) append_different(mesh, place_features(mesh, start, spacing), placed);
  if (std::ssize(placed.points) > asked) {
    throw Error(
        ErrorCode::precondition,
        fmt::format("{} asked for, and {} fixed or on features; ask for more generators",
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
}

/// The least number of generators of which the share that may be on curves suffices for these.
std::int64_t find_enough(const Mesh& mesh, const std::vector<EdgeId>& curves, double boundary, std::int64_t count) {
  while (true) {
    const Spaced spaced{mesh, spacing_beside(compute_area(mesh), boundary, count)};
    const double need = std::ceil(static_cast<double>(spaced.least(curves)) / kFeatureShare);
    if (!(need > static_cast<double>(count))) return count;
    count = static_cast<std::int64_t>(need);
  }
}

/// Leaves out loops of the boundary that would take too many generators. `others`: creases that are followed anyway.
void choose_loops(const Spaced& spaced, const std::vector<EdgeId>& others, std::vector<EdgeId>& boundary,
                  ConstrainedStart& start) {
  const auto fits = [&](const std::vector<EdgeId>& loops) {
    return !exceeds_share(spaced.least(join_edges(loops, others)), start.points.size());
  };
  const std::vector<CreaseGroup> loops = group_creases(spaced.mesh, boundary);
  start.loops = std::ssize(loops);
  if (boundary.empty() || fits(boundary)) return;
  start.enough_for_loops = find_enough(spaced.mesh, join_edges(boundary, others), total_length(spaced.mesh, boundary),
                                       std::ssize(start.points));
  boundary = keep_long(loops, spaced.spacing);
  if (!fits(boundary)) boundary.clear();
  const auto is_followed = [&](const CreaseGroup& loop) { return !boundary.empty() && loop.is_long(spaced.spacing); };
  start.unfollowed_loops = start.loops - std::ranges::count_if(loops, is_followed);
}

/// How many times as many generators as may be are needed on curves, if `count` are asked for.
double find_excess(const Mesh& mesh, const std::vector<EdgeId>& curves, double boundary, std::int64_t count) {
  const double spacing = spacing_beside(compute_area(mesh), boundary, count), asked = static_cast<double>(count);
  if (surely_exceeds_share(mesh, curves, spacing, static_cast<std::size_t>(count))) return kInfinity;
  const double opposite = static_cast<double>(CloseCurves(mesh, curves, spacing).expected().size());
  const double all = static_cast<double>(Spaced{mesh, spacing}.count(curves, spacing)) + opposite;
  return std::max(all / (kFeatureShare * asked), opposite / (kOppositeShare * asked));
}

/// A number of generators that can follow creases, up to kMostAdvised times as many as asked for; 0 if none is found.
/// The number on curves grows with the square root of that of all generators, but for corners.
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

/// Leaves out creases that are noise, and all if they would take too many generators.
void choose_creases(const Spaced& spaced, const std::vector<EdgeId>& boundary, std::vector<EdgeId>& creases,
                    ConstrainedStart& start) {
  const double length = total_length(spaced.mesh, creases);
  creases = keep_long(group_creases(spaced.mesh, creases), spaced.spacing);
  if (total_length(spaced.mesh, creases) < kLongShare * length) creases.clear();
  if (creases.empty()) return;
  const std::vector<EdgeId> curves = join_edges(boundary, creases);
  const auto excess_of = [&, border = total_length(spaced.mesh, boundary)](std::int64_t count) {
    return find_excess(spaced.mesh, curves, border, count);
  };
  const double excess = excess_of(std::ssize(start.points));
  if (excess <= 1) return;
  creases.clear();
  start.leaves_creases = true;
  start.enough_for_creases = find_enough_for_creases(std::ssize(start.points), excess, excess_of);
}

/// Finds the creases and the boundary as far as they are asked for, or preferred and possible.
void find_curves(const Mesh& mesh, const StartOptions& options, ConstrainedStart& start) {
  const bool prefers = options.prefers_boundary && !options.keep_boundary && !options.are_listed;
  std::vector<EdgeId> boundary, creases;
  if (options.keep_boundary || prefers) boundary = find_creases(mesh, {180, true});
  if (options.crease_angle) creases = find_creases(mesh, {*options.crease_angle, false});
  const Spaced spaced{mesh, spacing_beside(compute_area(mesh), total_length(mesh, boundary), std::ssize(start.points))};
  start.corner_distance = spaced.corner_distance();
  if (prefers) choose_loops(spaced, options.prefers_creases ? std::vector<EdgeId>() : creases, boundary, start);
  if (options.prefers_creases) choose_creases(spaced, boundary, creases, start);
  start.creases = join_edges(boundary, creases);
}

}  // namespace

ConstrainedStart constrain_start(const Mesh& mesh, std::vector<SurfacePoint> points, const StartOptions& options) {
  ConstrainedStart start;
  start.points = std::move(points);
  find_curves(mesh, options, start);
  const bool asks_for_creases = options.crease_angle && !options.prefers_creases;
  const bool asks = asks_for_creases || options.keep_boundary || !options.fixed.empty();
  if (!asks && start.creases.empty()) return start;
  FeatureGenerators placed = all_of(options.fixed, Freedom::fixed);
  if (options.are_listed) {
    append_listed(mesh, start, placed);
  } else {
    append_sampled(mesh, start, options, placed);
  }
  start.points = std::move(placed.points);
  start.freedom = std::move(placed.freedom);
  return start;
}

}  // namespace gvd
