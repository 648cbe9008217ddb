// Farthest sampling by incremental insertion: Eldar, Lindenbaum, Porat and Zeevi, The farthest point strategy for
// progressive image sampling, 1997; on surfaces Peyre and Cohen, Geodesic remeshing using front propagation, 2006.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "geodesic/lazy_max_heap.hpp"
#include "geodesic/nearest_field.hpp"
#include "geodesic/sampling_mesh.hpp"
#include "geodesic/sampling_random.hpp"
#include "geodesic/sampling_steps.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Edges longer than this many even spacings are split: a generator fits between the ends, a spacing from each.
constexpr double kLongEdge = 2;

/// For covering, edges longer than this part of the radius are split: a face then adds at most 1 / sqrt(3) of it, 7 %
/// of the radius, to the bound below.
constexpr double kCoveringEdge = 0.125;

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

  /// Inserts the vertex where distance + margin is largest, as long as more(that sum, its distance) says so.
  template <class More>
  void insert_farthest(const IdVector<VertexId, double>* margin, More more) {
    const auto key = [&](std::int32_t v) {
      return field_.distance(VertexId(v)) + (margin == nullptr ? 0 : (*margin)[VertexId(v)]);
    };
    std::vector<LazyMaxHeap::Item> items(static_cast<std::size_t>(mesh_.vertex_count()));
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) items[static_cast<std::size_t>(v)] = {key(v), v};
    LazyMaxHeap heap(std::move(items));
    while (!heap.empty()) {
      const auto top = heap.pop(key);
      if (!more(top.key, field_.distance(VertexId(top.id)))) return;
      insert(VertexId(top.id));
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
  sampler.insert_farthest(nullptr, [&](double, double distance) {
    // An insertion changes about a share of n / i vertices, so the work done grows with the logarithm.
    const auto done = static_cast<double>(sampler.chosen().size());
    report_progress(options.progress, "sampling", std::log1p(done) / std::log1p(double(options.count) + 1));
    return std::ssize(sampler.chosen()) < options.count && distance > least;
  });
  std::vector<SurfacePoint> points;
  for (const VertexId v : sampler.chosen()) points.push_back(positions.to_input(v));
  return points;
}

/// Largest distance that a point of the face has from the corner that is nearest to it.
double face_radius(double a, double b, double c, double twice_area) {
  if (a > c) std::swap(a, c);
  if (b > c) std::swap(b, c);
  // Acute: at the circumcentre. Else on the longest side, where the perpendicular bisectors of the others meet it, at
  // b / (2 cos A) from A and a / (2 cos B) from B.
  const bool acute = a * a + b * b > c * c;
  const double radius = acute ? a * b * c / (2 * twice_area)
                              : std::max(b * b * c / (b * b + c * c - a * a), a * a * c / (a * a + c * c - b * b));
  const double most =
      c / std::numbers::sqrt3;  // that of the equilateral triangle; also where rounding leaves no number
  return radius < most ? radius : most;
}

/// For each vertex the largest radius of its faces: a point whose nearest corner it is, is no farther from it.
IdVector<VertexId, double> compute_margins(const Mesh& mesh) {
  IdVector<VertexId, double> margin(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    const auto length = [&](int corner) { return mesh.length(Mesh::halfedge(f, corner)); };
    const double radius = face_radius(length(0), length(1), length(2), 2 * mesh.area(f));
    for (const VertexId v : mesh.vertices(f)) margin[v] = std::max(margin[v], radius);
  }
  return margin;
}

/// A lower bound on the splits until no edge is longer than `longest`: those of each edge that is there.
double least_splits(const Mesh& mesh, double longest) {
  double splits = 0;
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) {
    splits += std::max(0.0, std::ceil(mesh.length(EdgeId(e)) / longest) - 1);
  }
  return splits;
}

[[noreturn]] void throw_too_small(double radius) {
  throw Error(ErrorCode::precondition,
              "a covering radius of " + std::to_string(radius) +
                  " takes more generators than the surface can be split for; give a larger one");
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
  if (least_splits(mesh, longest) > kMaxSamplingVertices) throw_too_small(options.radius);
  const SamplingMesh positions(mesh, {longest, 0, kMaxSamplingVertices}, options.progress);
  if (longest_edge(positions.mesh()) > longest) throw_too_small(options.radius);
  const auto margin = compute_margins(positions.mesh());
  FarthestSampler sampler(positions.mesh(), options);
  sampler.start_components(std::numeric_limits<std::int64_t>::max());
  sampler.insert_farthest(&margin, [&](double reach, double distance) {
    if (reach <= options.radius) return false;
    if (distance == 0) throw_too_small(options.radius);  // a generator already: only a margin beyond the radius is left
    // The number of generators goes with the inverse square of the reach, and so does the logarithm of the work.
    report_progress(options.progress, "sampling", std::min(0.99, options.radius / reach));
    return true;
  });
  std::vector<SurfacePoint> points;
  for (const VertexId v : sampler.chosen()) points.push_back(positions.to_input(v));
  return points;
}

}  // namespace gvd
