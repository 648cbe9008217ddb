// Farthest points and coverings, by inserting one generator after the other.
//
// Idea: a field keeps the distance of every vertex from its nearest generator, and a heap the blocks of vertices, by
// their largest distance. For a covering the heap keeps faces, by an upper bound of the distance of their points.
// Source: Eldar, Lindenbaum, Porat and Zeevi, The farthest point strategy for progressive image sampling, 1997; on
// surfaces Peyre and Cohen, Geodesic remeshing using front propagation, 2006.
// Invariant: distances only fall, so the keys in the heap are upper bounds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <numbers>

#include "base/lazy_max_heap.hpp"
#include "geodesic/sampling/face_distance_bound.hpp"
#include "geodesic/sampling/nearest_field.hpp"
#include "geodesic/sampling/samplers.hpp"
#include "geodesic/sampling/sampling_mesh.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// A covering splits edges longer than this fraction of the radius. The distance bound of a face is then too large by
/// at most an eighth of the radius.
constexpr double kCoveringEdge = 0.25;

/// Each dart keeps this fraction of the radius from all darts before it, and in the end no vertex is farther than that
/// from a dart. Then no point of a face is farther than the radius, because it is at most kCoveringEdge / sqrt(3) radii
/// farther than the corners (compute_face_distance_bound).
constexpr double kDartSpacing = 1 - kCoveringEdge / std::numbers::sqrt3;

/// Number of consecutive places that share an item of the heap. Reading 64 distances in a row costs less than a cache
/// miss, whereas a heap with an item for each vertex takes a sixth of the time (1,000 points on 1.7 million faces).
constexpr std::int32_t kBlock = 64;

/// A vertex and its distance from the nearest generator. A farther vertex compares as larger and, of equally far ones,
/// the vertex with the smaller id does.
struct Farthest {
  double distance;
  VertexId vertex;
  auto operator<=>(const Farthest& other) const {
    const auto by_distance = distance <=> other.distance;
    return by_distance != 0 ? by_distance : other.vertex <=> vertex;
  }
  bool operator==(const Farthest& other) const = default;
};

/// The share of a covering's progress for the first generators of the components.
constexpr double kFirstShare = 0.1;

/// If some vertices coincide within rounding, sampling starts again with twice as many, at most this often.
constexpr int kMaxAttempts = 4;

/// A covering radius below this value needs more than kMaxSamplingVertices splits. Let `longest` = kCoveringEdge *
/// radius be the longest edge allowed. Two lower bounds on the number of splits give the value:
/// (a) an edge of length l needs l / longest - 1 splits;
/// (b) a face with such edges has at most the equilateral area sqrt(3) / 4 longest^2, and a split adds at most two
/// faces.
double least_covering_radius(const Mesh& mesh) {
  double length = 0;
  for (const EdgeId e : mesh.edges()) length += mesh.length(e);
  const double splits = kMaxSamplingVertices;
  const double by_length = length / (splits + mesh.edge_count());
  const double by_area = std::sqrt(4 / std::numbers::sqrt3 * compute_area(mesh) / (2 * splits + mesh.face_count()));
  return std::max(by_length, by_area) / kCoveringEdge;
}

/// Splitting takes up to about seven times the lower bound, because halved triangles are neither equilateral nor as
/// large as allowed. The error message suggests a radius larger by about the square root of that.
constexpr double kSuggestedFactor = 3;

[[noreturn]] void throw_too_small(double radius, double least) {
  throw Error(ErrorCode::precondition,
              fmt::format("a covering radius of {} is too small for this surface, which can't be split finely enough; "
                          "try {:.2g} or more",
                          radius, kSuggestedFactor * std::max(radius, least)));
}

/// Inserts farthest vertices of a mesh one by one.
class FarthestSampler {
 public:
  FarthestSampler(const SamplingMesh& split, const SamplingOptions& options)
      : split_(split),
        mesh_(split.mesh()),
        options_(options),
        field_(mesh_, options.front, options.progress),
        coincidence_(coincidence(mesh_)),
        is_chosen_(mesh_.vertex_count(), 0),
        faces_(sort_by_component()),
        random_(options.seed) {
    // Insertion i reaches about one vertex in i.
    field_.watch_insertions([this](std::size_t reached) {
      const double part = (double(chosen_.size()) + 1) * double(reached) / mesh_.vertex_count();
      report(double(chosen_.size()) + std::min(1.0, part));
    });
  }

  /// Returns up to `count` points; fewer if vertices of the mesh coincide within rounding.
  std::vector<SurfacePoint> sample() {
    start_components(options_.count);
    const double least = kMinSampleSpacing * mesh_.bbox_diagonal();
    const auto key = [&](std::int32_t block) { return farthest_in_block(block); };
    LazyMaxHeap<Farthest> heap((mesh_.vertex_count() + kBlock - 1) / kBlock, key);
    for (;;) {
      const Farthest top = heap.top(key).key;
      report(double(chosen_.size()));
      if (std::ssize(chosen_) >= options_.count || !(top.distance > least)) break;
      insert(top.vertex);
    }
    return points();
  }

  /// While the largest distance bound of a face is above the radius, inserts the farthest corner of that face.
  /// `least_radius` is for the message if lengths overflow.
  std::vector<SurfacePoint> cover(double least_radius) {
    start_components(mesh_.face_count());
    if (options_.blue_noise) throw_darts();
    const auto key = [&](std::int32_t f) { return distance_bound(FaceId(f)); };
    LazyMaxHeap heap(mesh_.face_count(), key);
    while (!heap.empty()) {
      const auto& top = heap.top(key);
      if (top.key <= options_.radius) break;
      const VertexId v = farthest_corner(FaceId(top.id));
      if (!(field_.distance(v) > 0)) throw_too_small(options_.radius, least_radius);
      covered_ = std::min(0.99, std::max(covered_, kFirstShare + (1 - kFirstShare) * options_.radius / top.key));
      report(double(chosen_.size()));
      insert(v);
    }
    return points();
  }

 private:
  /// Visits the vertices in random order, and inserts each that is far enough from all inserted before it: a maximal
  /// Poisson-disk sampling.
  void throw_darts() {
    const std::int32_t count = mesh_.vertex_count();
    std::int32_t thrown = 0;
    for (const VertexId v : draw_vertices(mesh_, count, options_.seed)) {
      covered_ = kFirstShare + (0.99 - kFirstShare) * double(thrown++) / count;
      if (field_.distance(v) < kDartSpacing * options_.radius) continue;
      report(double(chosen_.size()));
      insert(v);
    }
  }

  /// Reports how much of the sampling is done when `inserted` vertices are inserted, the last one perhaps in part.
  /// Insertion i changes about n / i vertices, so the work grows with the logarithm of i. The number of generators of a
  /// covering grows with the inverse square of the bound, and the work with its logarithm.
  void report(double inserted) const {
    const double components = double(first_face_.size() - 1);
    const double done = options_.kind == Sampling::covering_radius
                            ? std::max(covered_, kFirstShare * std::min(1.0, inserted / components))
                            : std::log1p(inserted) / std::log1p(double(options_.count) + 1);
    report_progress(options_.progress, "sampling", done);
  }

  /// Inserts one vertex in each component, or in the first `count` of them.
  void start_components(std::int64_t count) {
    const AreaSampler sampler(mesh_, faces_);
    for (std::size_t c = 0; c + 1 < first_face_.size() && std::ssize(chosen_) < count; ++c) {
      const FaceId f = sampler.draw_face(random_, first_face_[c], first_face_[c + 1]);
      insert(mesh_.vertices(f)[int(3 * random_.real())]);
    }
  }

  /// Inserts a vertex into the field, and chooses it. Across needles, marching can find distances that are far too
  /// large, so that the vertex may coincide with a chosen one. Then it is not chosen, but the distances near it are
  /// corrected nevertheless.
  void insert(VertexId v) {
    field_.insert(vertex_point(mesh_, v));
    if (coincides_with_chosen(v)) return;
    is_chosen_[v] = 1;
    chosen_.push_back(v);
  }

  bool coincides_with_chosen(VertexId v) const {
    const auto coincides = [&](VertexId u) {
      return is_chosen_[u] && (mesh_.position(u) - mesh_.position(v)).norm() <= coincidence_;
    };
    return std::ranges::any_of(faces_within(mesh_, vertex_point(mesh_, v), coincidence_),
                               [&](FaceId f) { return std::ranges::any_of(mesh_.vertices(f), coincides); });
  }

  /// The farthest vertex of a block of places.
  Farthest farthest_in_block(std::int32_t block) const {
    const std::int32_t first = block * kBlock, end = std::min(mesh_.vertex_count(), first + kBlock);
    Farthest best = at(PlaceId(first));
    for (std::int32_t p = first + 1; p < end; ++p) {
      // Only vertices that are at least as far need their ids, which are not in the cache.
      if (field_.distance(PlaceId(p)) >= best.distance) best = std::max(best, at(PlaceId(p)));
    }
    return best;
  }

  Farthest at(PlaceId p) const { return {field_.distance(p), field_.fans().vertex(p)}; }

  std::vector<SurfacePoint> points() const {
    std::vector<SurfacePoint> points;
    for (const VertexId v : chosen_) points.push_back(split_.to_input(v));
    return points;
  }

  std::vector<FaceId> sort_by_component() {
    const auto component = compute_face_components(mesh_);
    std::vector<FaceId> faces = list_faces(mesh_);
    std::stable_sort(faces.begin(), faces.end(), [&](FaceId f, FaceId g) { return component[f] < component[g]; });
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (i == 0 || component[faces[i]] != component[faces[i - 1]]) first_face_.push_back(i);
    }
    first_face_.push_back(faces.size());
    return faces;
  }

  VertexId farthest_corner(FaceId f) const {
    const auto& corners = mesh_.vertices(f);
    return *std::ranges::max_element(corners, {}, [&](VertexId v) { return field_.distance(v); });
  }

  /// No point of the face is farther than this from its nearest generator.
  double distance_bound(FaceId f) const {
    const auto& [a, b, c] = mesh_.vertices(f);
    return compute_face_distance_bound(mesh_.shape(f), {field_.distance(a), field_.distance(b), field_.distance(c)});
  }

  const SamplingMesh& split_;
  const Mesh& mesh_;
  const SamplingOptions& options_;
  NearestField field_;
  double coincidence_;  // mesh units
  IdVector<VertexId, char> is_chosen_;
  std::vector<std::size_t> first_face_;  // index in faces_ of each component's first face, and the end
  std::vector<FaceId> faces_;
  SeededRandom random_;
  std::vector<VertexId> chosen_;  // in order
  double covered_ = 0;            // share of a covering that is done
};

}  // namespace

SampledPoints sample_farthest(const Mesh& mesh, const SamplingOptions& options) {
  const double area = compute_area(mesh);
  const double longest = area > 0 ? kMaxEdgeSpacings * even_spacing(area, options.count) : kInfinity;
  std::int64_t least = options.count;
  for (int round = 0; round < kMaxAttempts; ++round, least *= 2) {
    if (least - mesh.vertex_count() > kMaxSamplingVertices) break;
    const SamplingMesh split(mesh, {longest, least, max_splits(mesh, options.count)}, options.progress);
    auto points = FarthestSampler(split, options).sample();
    if (std::ssize(points) == options.count) return points;
  }
  return Error(ErrorCode::precondition, fmt::format("the surface has no room for {}; ask for fewer",
                                                    counted(options.count, "generator", "different generators")));
}

std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options) {
  const double longest = kCoveringEdge * options.radius, least = least_covering_radius(mesh);
  if (options.radius < least) throw_too_small(options.radius, least);
  const SamplingMesh split(mesh, {longest, 0, kMaxSamplingVertices}, options.progress);
  if (longest_edge(split.mesh()) > longest) throw_too_small(options.radius, least);
  return FarthestSampler(split, options).cover(least);
}

}  // namespace gvd
