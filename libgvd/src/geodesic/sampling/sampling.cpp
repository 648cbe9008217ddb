// Spreads generators over the surface: checks the options, calls the sampler that they name, and draws random points,
// vertices and blue noise.
//
// Random points: the sums of the faces' areas cut an interval into pieces. A uniform number in it draws a face, two
// more a point of the face. Points that coincide within rounding are drawn again. Vertices are the beginning of a
// shuffle. Long edges: a queue gives the longest edge. Its split halves it, adds a face on each of its sides, and
// queues the new edges. The corners of each new face have coordinates in its parent that are exact binary fractions.
// Blue noise: start from five candidates for each point, drawn uniformly by area. Remove the candidate with the largest
// weight, again and again, until `count` points are left. A candidate's weight is the sum over its neighbours that are
// left, and the nearer one is, the more it counts.
// Source: G. Turk, Generating random points in triangles, 1990; the shuffle of Fisher and Yates; Rosenberg and Stenger, A
// lower bound on the angles of triangles constructed by bisecting the longest side, 1975; Yuksel, Sample elimination
// for generating Poisson disk sample sets, 2015, with geodesic distances. Farthest points are in sampling_farthest.cpp.
// Invariant: a sampler gets options in their ranges, so that it throws only where the mesh has no room. All numbers
// come from one engine, in an order that depends on the mesh and the count alone. So the same seed gives the same
// points on every platform.
#include "gvd/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <queue>
#include <tuple>
#include <utility>

#include "base/lazy_max_heap.hpp"
#include "geodesic/sampling/samplers.hpp"
#include "gvd/error.hpp"
#include "mesh/mesh_editor.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

void check_options(const Mesh& mesh, const SamplingOptions& options) {
  if (mesh.face_count() == 0) throw Error(ErrorCode::precondition, "the mesh has no face to put a generator on");
  if (options.kind == Sampling::covering_radius) {
    if (options.radius > 0 && std::isfinite(options.radius)) return;
    throw Error(ErrorCode::invalid_option,
                fmt::format("the covering radius is {}; give a number above 0", options.radius));
  }
  if (options.count < 1) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("the number of generators is {}; ask for at least 1", options.count));
  }
  // The working mesh adds a vertex for each generator.
  const std::int64_t maximum = std::int64_t{kMaxSamplingVertices} + mesh.vertex_count();
  if (options.count > maximum) {
    throw Error(ErrorCode::precondition,
                fmt::format("{} generators asked for; on this mesh ask for at most {}", options.count, maximum));
  }
}

/// Points closer than kMinSampleSpacing to others are drawn again, at most this often. Nearly always no point is.
constexpr int kMaxRedraws = 64;

/// Points of a list between two reports of progress, where each takes a few look-ups.
constexpr std::size_t kSweepStride = 1 << 12;

/// The later point of each pair that is too close. The distance is Euclidean on purpose, so that points on two sheets
/// that touch are kept apart, too.
std::vector<std::size_t> find_too_close(const std::vector<Vec3>& positions, double least, const Progress& progress) {
  // Sweep along a direction to which faces of ordinary models are not perpendicular.
  const Vec3 direction = Vec3(0.6180339887, 0.3819660113, 0.2360679775).normalized();
  std::vector<std::pair<double, std::size_t>> order(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) order[i] = {direction.dot(positions[i]), i};
  report_progress(progress, "sampling", 0);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> too_close;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % kSweepStride == 0) report_progress(progress, "sampling", 0);
    for (std::size_t k = i + 1; k < order.size() && order[k].first - order[i].first <= least; ++k) {
      const auto [earlier, later] = std::minmax(order[i].second, order[k].second);
      if ((positions[earlier] - positions[later]).norm() <= least) too_close.push_back(later);
    }
  }
  std::sort(too_close.begin(), too_close.end());
  too_close.erase(std::unique(too_close.begin(), too_close.end()), too_close.end());
  return too_close;
}

/// A split takes time in proportion to the faces round its ends, which may be all.
constexpr std::int64_t kSamplingStride = 1 << 6;

struct LongEdge {
  double length;
  EdgeId edge;
  bool operator<(const LongEdge& other) const { return std::tie(length, other.edge) < std::tie(other.length, edge); }
};

/// Candidates for each point (section 3.2 of the paper: five suffice).
constexpr std::int64_t kCandidates = 5;

/// Weight limiting of the paper's equation 3, with the paper's numbers: the distance of a pair counts as at least
/// 2 r_max beta (1 - (N / M)^gamma). N points are chosen out of M candidates, and gamma = 1.5.
constexpr double kBeta = 0.65;

constexpr StepPart kPairs{"sampling", 0, 0.9}, kElimination{"sampling", 0.9, 1};

struct Neighbour {
  std::int32_t candidate;
  float weight;
};

/// The paper's equation 2, with alpha = 8: 1 for coincident points, 0 at `diameter`.
float compute_weight(double distance, double least, double diameter) {
  const double w = 1 - std::max(distance, least) / diameter;
  const double w2 = w * w, w4 = w2 * w2;
  return float(w4 * w4);
}

/// All pairs of candidates whose geodesic distance is below `diameter`.
class PairFinder {
 public:
  PairFinder(const Mesh& mesh, const std::vector<SurfacePoint>& candidates, const SamplingOptions& options)
      : mesh_(mesh),
        candidates_(candidates),
        in_face_(mesh.face_count()),
        march_(mesh, options.front, options.progress),
        seen_(mesh.face_count(), -1) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (i % kSweepStride == 0) report_progress(options.progress, kPairs, 0);
      positions_.push_back(position(mesh, candidates[i]));
      in_face_[candidates[i].face].push_back(static_cast<std::int32_t>(i));
    }
  }

  /// The candidates in each face, ascending. Visiting them in the order of faces keeps memory accesses local.
  const IdVector<FaceId, std::vector<std::int32_t>>& by_face() const { return in_face_; }

  /// Calls visit(j, distance) for every candidate j > i whose distance from i is below `diameter`.
  template <class Visit>
  void for_each_after(std::int32_t i, double diameter, Visit visit) {
    march_.run(candidates_[i], diameter);
    for (const PlaceId p : march_.reached()) {
      for_each_outgoing(mesh_, march_.fans().vertex(p),
                        [&](HalfedgeId h) { visit_face(Mesh::face(h), i, diameter, visit); });
    }
  }

 private:
  template <class Visit>
  void visit_face(FaceId f, std::int32_t i, double diameter, Visit visit) {
    if (seen_[f] == i) return;
    seen_[f] = i;
    for (const std::int32_t j : in_face_[f]) {
      // No path is shorter than the straight line through space.
      if (j <= i || (positions_[i] - positions_[j]).norm() >= diameter) continue;
      const double distance = march_.distance(candidates_[j]);
      if (distance < diameter) visit(j, distance);
    }
  }

  const Mesh& mesh_;
  const std::vector<SurfacePoint>& candidates_;
  std::vector<Vec3> positions_;
  IdVector<FaceId, std::vector<std::int32_t>> in_face_;
  LocalMarch march_;
  IdVector<FaceId, std::int32_t> seen_;  // the last candidate whose search visited the face
};

/// The neighbours of each candidate, with the weights of the pairs.
std::vector<std::vector<Neighbour>> find_neighbours(const Mesh& mesh, const std::vector<SurfacePoint>& candidates,
                                                    const SamplingOptions& options) {
  // The largest spacing that `count` points of the plane can have: the paper's 2 r_max.
  const double diameter = even_spacing(compute_area(mesh), options.count);
  const double share = double(options.count) / double(candidates.size());
  const double least = diameter * kBeta * (1 - share * std::sqrt(share));
  PairFinder finder(mesh, candidates, options);
  std::vector<std::vector<Neighbour>> neighbours(candidates.size());
  std::int64_t done = 0;
  for (const auto& in_face : finder.by_face()) {
    for (const std::int32_t first : in_face) {
      report_progress(options.progress, kPairs, double(done++) / double(candidates.size()));
      finder.for_each_after(first, diameter, [&](std::int32_t second, double distance) {
        const float weight = compute_weight(distance, least, diameter);
        neighbours[first].push_back({second, weight});
        neighbours[second].push_back({first, weight});
      });
    }
  }
  return neighbours;
}

/// Removes the candidate with the largest weight until `count` are left; returns which ones these are.
std::vector<char> eliminate(const std::vector<std::vector<Neighbour>>& neighbours, std::int64_t count,
                            const Progress& progress) {
  std::vector<double> weight(neighbours.size(), 0);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (i % kSweepStride == 0) report_progress(progress, kElimination, 0);
    for (const Neighbour& n : neighbours[i]) weight[i] += double(n.weight);
  }
  const auto key = [&](std::int32_t i) { return weight[i]; };
  LazyMaxHeap heap(static_cast<std::int32_t>(weight.size()), key);
  std::vector<char> kept(weight.size(), 1);
  for (std::int64_t left = std::ssize(kept); left > count; --left) {
    report_progress(progress, kElimination, double(std::ssize(kept) - left) / double(std::ssize(kept) - count));
    const std::int32_t i = heap.top(key).id;
    heap.pop();
    kept[i] = 0;
    for (const Neighbour& n : neighbours[i]) weight[n.candidate] -= double(n.weight);
  }
  return kept;
}

/// `count` points inside faces, uniform by area, no two closer than kMinSampleSpacing.
/// Throws Error{precondition} if the area is 0 or not finite, or if no such points were found.
std::vector<SurfacePoint> sample_random(const Mesh& mesh, std::int64_t count, const SamplingOptions& options) {
  require_area(mesh);
  const AreaSampler sampler(mesh, list_faces(mesh));
  SeededRandom random(options.seed);
  std::vector<SurfacePoint> points(count);
  std::vector<Vec3> positions(count);
  const auto draw = [&](std::size_t i) {
    if (i % kSamplingStride == 0) report_progress(options.progress, "sampling", 0);
    points[i] = sampler.draw_point(random);
    positions[i] = position(mesh, points[i]);
  };
  for (std::size_t i = 0; i < points.size(); ++i) draw(i);
  for (int round = 0; round < kMaxRedraws; ++round) {
    const auto too_close = find_too_close(positions, kMinSampleSpacing * mesh.bbox_diagonal(), options.progress);
    if (too_close.empty()) return points;
    for (const std::size_t i : too_close) draw(i);
  }
  throw Error(ErrorCode::precondition, fmt::format("the surface is too small beside its bounding box for {} different "
                                                   "points; ask for fewer, or remove far parts",
                                                   count));
}

/// Vertices of `draw_vertices` as surface points. Throws Error{precondition} if the mesh has fewer vertices.
std::vector<SurfacePoint> sample_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  if (count > mesh.vertex_count()) {
    throw Error(
        ErrorCode::precondition,
        fmt::format("{} different vertices asked for, and the mesh has {}; ask for fewer, or take random points", count,
                    mesh.vertex_count()));
  }
  std::vector<SurfacePoint> points;
  for (const VertexId v : draw_vertices(mesh, count, seed)) points.push_back(vertex_point(mesh, v));
  return points;
}

/// Sampling::poisson: `count` points with blue-noise spacing. The caller has checked the options.
std::vector<SurfacePoint> sample_poisson(const Mesh& mesh, const SamplingOptions& options) {
  if (options.count > kMaxSamplingVertices) {
    throw Error(ErrorCode::precondition,
                fmt::format("poisson sampling gives at most {} generators; ask for fewer, or for random ones",
                            kMaxSamplingVertices));
  }
  const double longest = kMaxEdgeSpacings * even_spacing(require_area(mesh), options.count);
  const SamplingMesh split(mesh, {longest, 0, max_splits(mesh, options.count)}, options.progress);
  const auto candidates = sample_random(split.mesh(), kCandidates * options.count, options);
  const auto kept = eliminate(find_neighbours(split.mesh(), candidates, options), options.count, options.progress);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (kept[i]) points.push_back(split.to_input(candidates[i]));
  }
  return points;
}

}  // namespace

std::vector<SurfacePoint> sample_generators(const Mesh& mesh, const SamplingOptions& options) {
  check_options(mesh, options);
  report_progress(options.progress, "sampling", 0);
  switch (options.kind) {
    case Sampling::farthest:
      return sample_farthest(mesh, options);
    case Sampling::random:
      return sample_random(mesh, options.count, options);
    case Sampling::vertices:
      return sample_vertices(mesh, options.count, options.seed);
    case Sampling::poisson:
      return sample_poisson(mesh, options);
    case Sampling::covering_radius:
      return sample_covering(mesh, options);
  }
  return {};
}

double even_spacing(double area, std::int64_t count) {
  // Each point has two triangles of area sqrt(3) / 4 times the square of the side.
  return std::sqrt(2 * area / (std::numbers::sqrt3 * double(count)));
}

double even_count(double area, double spacing) {
  return std::max(1.0, std::round(2 * area / (std::numbers::sqrt3 * spacing * spacing)));
}

std::int64_t max_splits(const Mesh& mesh, std::int64_t count) {
  return std::min<std::int64_t>(4 * (mesh.vertex_count() + count), kMaxSamplingVertices);
}

std::vector<VertexId> draw_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed) {
  const IdRange<VertexId> all = mesh.vertices();
  std::vector<VertexId> order(all.begin(), all.end());
  SeededRandom random(seed);
  for (std::int64_t i = 0; i < count; ++i) std::swap(order[i], order[i + random.below(order.size() - i)]);
  order.resize(count);
  return order;
}

std::vector<FaceId> list_faces(const Mesh& mesh) {
  const IdRange<FaceId> faces = mesh.faces();
  return {faces.begin(), faces.end()};
}

double require_area(const Mesh& mesh) {
  const double area = compute_area(mesh);
  if (area > 0 && std::isfinite(area)) return area;
  throw Error(ErrorCode::precondition,
              "random points need a surface whose area is finite and not 0; take farthest points, or scale the mesh");
}

AreaSampler::AreaSampler(const Mesh& mesh, std::vector<FaceId> faces) : faces_(std::move(faces)) {
  sums_.reserve(faces_.size() + 1);
  sums_.push_back(0);
  for (const FaceId f : faces_) sums_.push_back(sums_.back() + mesh.area(f));
}

FaceId AreaSampler::draw_face(SeededRandom& random, std::size_t first, std::size_t last) const {
  const double target = sums_[first] + random.real() * (sums_[last] - sums_[first]);
  // The first face whose cumulated area exceeds the target; a face with zero area is never chosen.
  const double* const sums = sums_.data();
  return faces_[std::upper_bound(sums + first + 1, sums + last, target) - sums - 1];
}

SurfacePoint AreaSampler::draw_point(SeededRandom& random) const {
  for (;;) {
    const FaceId f = draw_face(random, 0, faces_.size());
    // Uniform in the triangle, by Turk.
    const double root = std::sqrt(random.real()), along = random.real();
    const std::array<double, 3> bary{1 - root, root * (1 - along), root * along};
    if (*std::min_element(bary.begin(), bary.end()) > kBarycentricSnap) return make_surface_point(f, bary);
  }
}

SamplingMesh::SamplingMesh(const Mesh& input, const SplitOptions& options, const Progress& progress) : input_(&input) {
  if (longest_edge(input) <= options.max_edge_length && input.vertex_count() >= options.min_vertices) return;
  split_ = true;
  copy_ = input;
  subfaces_.reserve(copy_.face_count());
  for (const FaceId f : copy_.faces()) subfaces_.push_back({f, kWholeTriangle});
  std::vector<LongEdge> edges;
  edges.reserve(input.edge_count());
  for (const EdgeId e : input.edges()) edges.push_back({input.length(e), e});
  std::priority_queue<LongEdge> queue(std::less<LongEdge>(), std::move(edges));
  for (;;) {
    const LongEdge top = queue.top();
    const std::int64_t vertices = copy_.vertex_count();
    const bool is_long = top.length > options.max_edge_length && vertices - input.vertex_count() < options.max_added;
    if (!is_long && vertices >= options.min_vertices) break;
    queue.pop();
    if (top.length != copy_.length(top.edge)) continue;  // one half of an edge that was split
    if (vertices % kSamplingStride == 0) report_progress(progress, "splitting edges", share_done(options, top.length));
    const std::int32_t before = copy_.edge_count();
    split(top.edge);
    queue.push({copy_.length(top.edge), top.edge});
    for (std::int32_t e = before; e < copy_.edge_count(); ++e) queue.push({copy_.length(EdgeId(e)), EdgeId(e)});
  }
}

/// The number of vertices grows with the inverse square of the longest edge.
double SamplingMesh::share_done(const SplitOptions& options, double longest) const {
  const double added = copy_.vertex_count() - input_->vertex_count();
  const double by_length = std::pow(std::min(1.0, options.max_edge_length / longest), 2);
  const double asked = double(options.min_vertices - input_->vertex_count());
  return std::min(by_length, asked > 0 ? std::min(1.0, added / asked) : 1.0);
}

void SamplingMesh::split(EdgeId e) {
  const HalfedgeId h = copy_.halfedge(e), twin = copy_.twin(h);
  const Vec3 middle = 0.5 * copy_.position(copy_.from(h)) + 0.5 * copy_.position(copy_.to(h));
  const FaceId appended(copy_.face_count());
  MeshEditor(copy_).split_edge(h, middle);
  subfaces_.resize(copy_.face_count());
  split_subface(h, appended);
  if (twin.valid()) split_subface(twin, FaceId(appended.value() + 1));
}

/// Records the split of h = (a, b): its face is now (a, middle, c), and `appended` is (middle, b, c).
void SamplingMesh::split_subface(HalfedgeId h, FaceId appended) {
  SubFace& subface = subfaces_[Mesh::face(h)];
  const int i = Mesh::corner(h);
  const Bary a = subface.corners[i], b = subface.corners[(i + 1) % 3], c = subface.corners[(i + 2) % 3];
  const Bary middle = mix(a, b, 0.5);
  subface.corners = {a, middle, c};
  subfaces_[appended] = {subface.parent, {middle, b, c}};
}

SurfacePoint SamplingMesh::to_input(const SurfacePoint& point) const {
  if (!split_) return point;
  const SubFace& subface = subfaces_[point.face];
  return make_surface_point(subface.parent, compose(subface.corners, point.bary));
}

SurfacePoint SamplingMesh::to_input(VertexId v) const {
  if (v.value() < input_->vertex_count()) return vertex_point(*input_, v);
  return to_input(vertex_point(copy_, v));
}

}  // namespace gvd
