// Farthest-point sampling by incremental insertion: Eldar, Lindenbaum, Porat and Zeevi, The farthest point strategy for
// progressive image sampling, 1997; on surfaces Peyre and Cohen, Geodesic remeshing using front propagation, 2006.
#include "geodesic/sampling/sampling_farthest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "base/lazy_max_heap.hpp"
#include "geodesic/sampling/face_distance_bound.hpp"
#include "geodesic/sampling/nearest_field.hpp"
#include "geodesic/sampling/sampling_mesh.hpp"
#include "geodesic/sampling/sampling_random.hpp"
#include "geodesic/sampling/sampling_spacing.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/text.hpp"
#include "gvd/vec.hpp"

namespace gvd {
namespace {

/// A covering splits edges longer than this fraction of the radius. The distance bound of a face is then too large by
/// at most an eighth of the radius.
constexpr double kCoveringEdge = 0.25;

/// Share of a covering's progress that the first generators of the components have.
constexpr double kFirstShare = 0.1;

/// If some vertices coincide within rounding, sampling starts again with twice as many, at most this often.
constexpr int kMaxAttempts = 4;

/// Inserts farthest vertices of a mesh one by one.
class FarthestSampler {
 public:
  FarthestSampler(const Mesh& mesh, const SamplingOptions& options)
      : mesh_(mesh), field_(mesh, options.front), faces_(sort_by_component()), random_(options.seed) {
    field_.watch_insertions([this, &progress = options.progress](std::size_t reached) {
      // Insertion i reaches about one vertex in i.
      const double chosen = static_cast<double>(chosen_.size());
      const double part = (chosen + 1) * static_cast<double>(reached) / static_cast<double>(mesh_.vertex_count());
      report_progress(progress, "sampling", share_(chosen + std::min(1.0, part)));
    });
  }

  /// How much of the sampling is done, in [0, 1], once so many vertices are inserted; the last one maybe in part.
  void set_share(std::function<double(double inserted)> share) { share_ = std::move(share); }
  std::size_t component_count() const { return first_face_.size() - 1; }

  /// The vertices inserted so far, in order.
  const std::vector<VertexId>& chosen() const { return chosen_; }

  /// One vertex in each component, or in the first `count` of them.
  void start_components(std::int64_t count) {
    const AreaSampler sampler(mesh_, faces_);
    for (std::size_t c = 0; c + 1 < first_face_.size() && std::ssize(chosen_) < count; ++c) {
      const FaceId f = sampler.draw_face(random_, first_face_[c], first_face_[c + 1]);
      insert(mesh_.vertices(f)[static_cast<std::size_t>(3 * random_.real())]);
    }
  }

  /// Inserts the farthest vertex while more(its distance) is true.
  template <class More>
  void insert_farthest(More more) {
    const auto key = [&](std::int32_t v) { return field_.distance(VertexId(v)); };
    LazyMaxHeap heap(mesh_.vertex_count(), key);
    for (; !heap.empty(); heap.pop()) {
      const auto& top = heap.top(key);
      if (!more(top.key)) return;
      insert(VertexId(top.id));
    }
  }

  /// Takes the face with the largest distance bound and inserts its farthest corner, while more(that bound, the
  /// corner's distance) is true.
  template <class More>
  void insert_in_farthest_face(More more) {
    const auto key = [&](std::int32_t f) { return distance_bound(FaceId(f)); };
    LazyMaxHeap heap(mesh_.face_count(), key);
    while (!heap.empty()) {
      const auto& top = heap.top(key);
      const VertexId v = farthest_corner(FaceId(top.id));
      if (!more(top.key, field_.distance(v))) return;
      insert(v);
    }
  }

 private:
  void insert(VertexId v) {
    field_.insert(vertex_point(mesh_, v));
    chosen_.push_back(v);
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
    return *std::max_element(corners.begin(), corners.end(),
                             [&](VertexId v, VertexId w) { return field_.distance(v) < field_.distance(w); });
  }

  /// No point of the face is farther than this from its nearest generator.
  double distance_bound(FaceId f) const {
    const auto length = [&](int corner) { return mesh_.length(Mesh::halfedge(f, corner)); };
    const auto& [a, b, c] = mesh_.vertices(f);
    return compute_face_distance_bound({length(0), length(1), length(2)}, 2 * mesh_.area(f),
                                       {field_.distance(a), field_.distance(b), field_.distance(c)});
  }

  const Mesh& mesh_;
  NearestField field_;
  std::vector<std::size_t> first_face_;  // of each component in faces_, and the end
  std::vector<FaceId> faces_;
  SeededRandom random_;
  std::vector<VertexId> chosen_;
  std::function<double(double)> share_ = [](double) { return 0.0; };
};

/// Up to `count` points; fewer where the vertices of the sampling mesh coincide within rounding.
std::vector<SurfacePoint> try_farthest(const SamplingMesh& split, const SamplingOptions& options) {
  const Mesh& mesh = split.mesh();
  const double least = kMinSampleSpacing * mesh.bbox_diagonal();
  FarthestSampler sampler(mesh, options);
  // Insertion i changes about n / i vertices, so the work done grows with the logarithm of i.
  const auto share = [&](double inserted) { return std::log1p(inserted) / std::log1p(double(options.count) + 1); };
  sampler.set_share(share);
  sampler.start_components(options.count);
  sampler.insert_farthest([&](double distance) {
    report_progress(options.progress, "sampling", share(static_cast<double>(sampler.chosen().size())));
    return std::ssize(sampler.chosen()) < options.count && distance > least;
  });
  std::vector<SurfacePoint> points;
  for (const VertexId v : sampler.chosen()) points.push_back(split.to_input(v));
  return points;
}

/// A covering radius below this value needs more than kMaxSamplingVertices splits. Let `longest` = kCoveringEdge *
/// radius be the longest edge allowed. Two lower bounds on the number of splits give the value:
/// (a) an edge of length l needs l / longest - 1 splits;
/// (b) a face with such edges has at most the equilateral area sqrt(3) / 4 longest^2, and a split adds at most two
/// faces.
double least_covering_radius(const Mesh& mesh) {
  double length = 0;
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) length += mesh.length(EdgeId(e));
  const double splits = kMaxSamplingVertices;
  const double by_length = length / (splits + mesh.edge_count());
  const double by_area = std::sqrt(4 / std::numbers::sqrt3 * compute_area(mesh) / (2 * splits + mesh.face_count()));
  return std::max(by_length, by_area) / kCoveringEdge;
}

/// Splitting takes up to some seven times the lower bound, since halved triangles are neither equilateral nor as large
/// as allowed. The error message suggests a radius larger by about the square root of that.
constexpr double kSuggestedFactor = 3;

[[noreturn]] void throw_too_small(double radius, double least) {
  throw Error(ErrorCode::precondition,
              fmt::format("a covering radius of {} is too small for this surface, which can't be split finely enough; "
                          "try {:.2g} or more",
                          radius, kSuggestedFactor * std::max(radius, least)));
}

}  // namespace

std::vector<SurfacePoint> sample_farthest(const Mesh& mesh, const SamplingOptions& options) {
  const double area = compute_area(mesh);
  const double longest = area > 0 ? kMaxEdgeSpacings * even_spacing(area, options.count) : kInfinity;
  std::int64_t least = options.count;
  for (int round = 0; round < kMaxAttempts; ++round, least *= 2) {
    if (least - mesh.vertex_count() > kMaxSamplingVertices) break;
    const SamplingMesh split(mesh, {longest, least, max_splits(mesh, options.count)}, options.progress);
    auto points = try_farthest(split, options);
    if (std::ssize(points) == options.count) return points;
  }
  throw Error(ErrorCode::precondition, fmt::format("the surface has no room for {}; ask for fewer",
                                                   counted(options.count, "generator", "different generators")));
}

std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options) {
  const double longest = kCoveringEdge * options.radius;
  const double least = least_covering_radius(mesh);
  if (options.radius < least) throw_too_small(options.radius, least);
  const SamplingMesh split(mesh, {longest, 0, kMaxSamplingVertices}, options.progress);
  if (longest_edge(split.mesh()) > longest) throw_too_small(options.radius, least);
  FarthestSampler sampler(split.mesh(), options);
  // A tenth for the first ones. Then the number of generators grows with the inverse square of the bound, and the work
  // with its logarithm.
  double done = 0;
  const auto components = static_cast<double>(sampler.component_count());
  sampler.set_share(
      [&](double inserted) { return std::max(done, kFirstShare * std::min(1.0, inserted / components)); });
  sampler.start_components(std::numeric_limits<std::int64_t>::max());
  sampler.insert_in_farthest_face([&](double bound, double distance) {
    if (bound <= options.radius) return false;
    if (!(distance > 0)) throw_too_small(options.radius, least);  // where lengths overflow
    done = std::min(0.99, kFirstShare + (1 - kFirstShare) * options.radius / bound);
    report_progress(options.progress, "sampling", done);
    return true;
  });
  std::vector<SurfacePoint> points;
  for (const VertexId v : sampler.chosen()) points.push_back(split.to_input(v));
  return points;
}

}  // namespace gvd
