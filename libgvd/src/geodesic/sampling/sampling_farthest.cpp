// Farthest sampling by incremental insertion: Eldar, Lindenbaum, Porat and Zeevi, The farthest point strategy for
// progressive image sampling, 1997; on surfaces Peyre and Cohen, Geodesic remeshing using front propagation, 2006.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/lazy_max_heap.hpp"
#include "geodesic/sampling/face_reach.hpp"
#include "geodesic/sampling/nearest_field.hpp"
#include "geodesic/sampling/sampling_mesh.hpp"
#include "geodesic/sampling/sampling_random.hpp"
#include "geodesic/sampling/sampling_steps.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Edges longer than this many even spacings are split: a generator fits between the ends, a spacing from each.
constexpr double kLongEdge = 2;

/// For covering, edges longer than this part of the radius are split: what is known of the inside of a face from its
/// corners is then at most an eighth of the radius above the truth.
constexpr double kCoveringEdge = 0.25;

/// How often vertices that rounding can't tell apart make the sampling start again with twice as many.
constexpr int kMaxRounds = 4;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Farthest points among the vertices of a mesh, one after the other.
class FarthestSampler {
 public:
  FarthestSampler(const Mesh& mesh, const SamplingOptions& options)
      : mesh_(mesh), field_(mesh, options.front), faces_(sort_by_component()), random_(options.seed) {}

  /// The vertices so far, in the order of their insertion.
  const std::vector<VertexId>& chosen() const { return chosen_; }

  /// One vertex in each component, or in the first `count` of them.
  void start_components(std::int64_t count) {
    const AreaSampler sampler(mesh_, faces_);
    for (std::size_t c = 0; c + 1 < first_face_.size() && std::ssize(chosen_) < count; ++c) {
      const FaceId f = sampler.draw_face(random_, first_face_[c], first_face_[c + 1]);
      insert(mesh_.vertices(f)[static_cast<std::size_t>(3 * random_.real())]);
    }
  }

  /// Inserts the farthest vertex as long as more(its distance) says so.
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

  /// Inserts the farthest vertex of the face that reaches farthest, as long as more(that reach, the vertex's distance)
  /// says so.
  template <class More>
  void insert_in_farthest_face(More more) {
    const auto key = [&](std::int32_t f) { return reach(FaceId(f)); };
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
  double reach(FaceId f) const {
    const auto length = [&](int corner) { return mesh_.length(Mesh::halfedge(f, corner)); };
    const auto& [a, b, c] = mesh_.vertices(f);
    return compute_reach({length(0), length(1), length(2)}, 2 * mesh_.area(f),
                         {field_.distance(a), field_.distance(b), field_.distance(c)});
  }

  const Mesh& mesh_;
  NearestField field_;
  std::vector<std::size_t> first_face_;  // of each component in faces_, and the end
  std::vector<FaceId> faces_;
  SeededRandom random_;
  std::vector<VertexId> chosen_;
};

/// As many of `count` points as the vertices of the sampling mesh are places that rounding can tell apart.
std::vector<SurfacePoint> try_farthest(const SamplingMesh& positions, const SamplingOptions& options) {
  const Mesh& mesh = positions.mesh();
  const double least = kLeastSpacing * mesh.bbox_diagonal();
  FarthestSampler sampler(mesh, options);
  sampler.start_components(options.count);
  sampler.insert_farthest([&](double distance) {
    // An insertion changes about a share of n / i vertices, so the work done grows with the logarithm.
    const auto done = static_cast<double>(sampler.chosen().size());
    report_progress(options.progress, "sampling", std::log1p(done) / std::log1p(double(options.count) + 1));
    return std::ssize(sampler.chosen()) < options.count && distance > least;
  });
  std::vector<SurfacePoint> points;
  for (const VertexId v : sampler.chosen()) points.push_back(positions.to_input(v));
  return points;
}

/// A covering radius below this certainly takes more than kMaxSamplingVertices splits until no edge is longer than
/// kCoveringEdge of it, by two lower bounds on their number. An edge of length l takes l / longest - 1 of its own. And
/// since no triangle with such edges has more area than the equilateral one, sqrt(3) / 4 longest^2, and a split adds
/// two faces at most, they are half of area / (sqrt(3) / 4 longest^2) without the faces that are there.
double least_covering_radius(const Mesh& mesh) {
  double length = 0;
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) length += mesh.length(EdgeId(e));
  const double splits = kMaxSamplingVertices;
  const double by_length = length / (splits + mesh.edge_count());
  const double by_area = std::sqrt(4 / std::numbers::sqrt3 * compute_area(mesh) / (2 * splits + mesh.face_count()));
  return std::max(by_length, by_area) / kCoveringEdge;
}

/// Splitting may take some seven times the lower bound, as halved triangles are neither equilateral nor as large as
/// allowed: the square root of that is the factor of the radius to try.
constexpr double kTryFactor = 3;

[[noreturn]] void throw_too_small(double radius, double least) {
  throw Error(ErrorCode::precondition,
              fmt::format("a covering radius of {} is too small for this surface, which can't be split finely enough; "
                          "try {:.2g} or more",
                          radius, kTryFactor * std::max(radius, least)));
}

}  // namespace

std::vector<SurfacePoint> sample_farthest(const Mesh& mesh, const SamplingOptions& options) {
  const double area = compute_area(mesh);
  const double longest = area > 0 ? kLongEdge * even_spacing(area, options.count) : kInfinity;
  std::int64_t least = options.count;
  for (int round = 0; round < kMaxRounds; ++round, least *= 2) {
    if (least - mesh.vertex_count() > kMaxSamplingVertices) break;
    const SamplingMesh positions(mesh, {longest, least, most_splits(mesh, options.count)}, options.progress);
    auto points = try_farthest(positions, options);
    if (std::ssize(points) == options.count) return points;
  }
  throw Error(ErrorCode::precondition,
              "the surface has no room for " + std::to_string(options.count) + " different generators; ask for fewer");
}

std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options) {
  const double longest = kCoveringEdge * options.radius;
  const double least = least_covering_radius(mesh);
  if (options.radius < least) throw_too_small(options.radius, least);
  const SamplingMesh positions(mesh, {longest, 0, kMaxSamplingVertices}, options.progress);
  if (longest_edge(positions.mesh()) > longest) throw_too_small(options.radius, least);
  FarthestSampler sampler(positions.mesh(), options);
  sampler.start_components(std::numeric_limits<std::int64_t>::max());
  sampler.insert_in_farthest_face([&](double reach, double distance) {
    if (reach <= options.radius) return false;
    if (!(distance > 0)) throw_too_small(options.radius, least);  // where lengths overflow
    // The number of generators goes with the inverse square of the reach, and so does the logarithm of the work.
    report_progress(options.progress, "sampling", std::min(0.99, options.radius / reach));
    return true;
  });
  std::vector<SurfacePoint> points;
  for (const VertexId v : sampler.chosen()) points.push_back(positions.to_input(v));
  return points;
}

}  // namespace gvd
