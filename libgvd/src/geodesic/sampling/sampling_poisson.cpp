// Blue noise: random points that are evenly spaced.
//
// Idea: start from five candidates for each point, drawn uniformly by area. Remove the candidate with the largest
// weight, again and again, until `count` points are left. A candidate's weight is a sum over its remaining neighbours,
// in which nearer neighbours count more.
// Source: Yuksel, Sample elimination for generating Poisson disk sample sets, 2015, with geodesic distances.
// Invariant: weights only fall, so that the keys in the heap are upper bounds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/lazy_max_heap.hpp"
#include "geodesic/marching/local_march.hpp"
#include "geodesic/sampling/samplers.hpp"
#include "geodesic/sampling/sampling_mesh.hpp"
#include "gvd/error.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

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

/// The neighbours of each candidate, with the weights of the pairs. A local march from each candidate finds its pairs
/// with later ones.
std::vector<std::vector<Neighbour>> find_neighbours(const Mesh& mesh, const std::vector<SurfacePoint>& candidates,
                                                    const SamplingOptions& options) {
  // The largest spacing that `count` points of the plane can have: the paper's 2 r_max.
  const double diameter = even_spacing(compute_area(mesh), options.count);
  const double share = double(options.count) / double(candidates.size());
  const double least = diameter * kBeta * (1 - share * std::sqrt(share));
  LocalMarch march(mesh, options.front, options.progress);
  std::vector<Vec3> positions;
  IdVector<FaceId, std::vector<std::int32_t>> in_face(mesh.face_count());  // ascending
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i % kSweepStride == 0) report_progress(options.progress, kPairs, 0);
    positions.push_back(position(mesh, candidates[i]));
    in_face[candidates[i].face].push_back(static_cast<std::int32_t>(i));
  }
  std::vector<std::vector<Neighbour>> neighbours(candidates.size());
  IdVector<FaceId, std::int32_t> seen(mesh.face_count(), -1);  // the last candidate whose march came to the face
  const auto add_pairs = [&](std::int32_t first, FaceId f) {
    if (seen[f] == first) return;
    seen[f] = first;
    for (const std::int32_t second : in_face[f]) {
      // No path is shorter than the straight line through space.
      if (second <= first || (positions[first] - positions[second]).norm() >= diameter) continue;
      const double distance = march.distance(candidates[second]);
      if (!(distance < diameter)) continue;
      const float weight = compute_weight(distance, least, diameter);
      neighbours[first].push_back({second, weight});
      neighbours[second].push_back({first, weight});
    }
  };
  // The loop follows the order of faces, so that memory accesses stay local.
  std::int64_t done = 0;
  for (const std::vector<std::int32_t>& firsts : in_face) {
    for (const std::int32_t first : firsts) {
      report_progress(options.progress, kPairs, double(done++) / double(candidates.size()));
      march.run(candidates[first], diameter);
      for (const PlaceId p : march.reached()) {
        for_each_outgoing(mesh, march.fans().vertex(p), [&](HalfedgeId h) { add_pairs(first, Mesh::face(h)); });
      }
    }
  }
  return neighbours;
}

/// Removes the candidate with the largest weight until `count` are left. Returns for each candidate whether it is left.
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

}  // namespace

SampledPoints sample_poisson(const Mesh& mesh, const SamplingOptions& options) {
  if (options.count > kMaxSamplingVertices) {
    return Error(ErrorCode::precondition,
                 fmt::format("poisson sampling gives at most {} generators; ask for fewer, or for random ones",
                             kMaxSamplingVertices));
  }
  const double longest = kMaxEdgeSpacings * even_spacing(require_area(mesh), options.count);
  const SamplingMesh split(mesh, {longest, 0, max_splits(mesh, options.count)}, options.progress);
  const SampledPoints sampled = sample_random(split.mesh(), kCandidates * options.count, options);
  if (const Error* const error = std::get_if<Error>(&sampled)) return *error;
  const auto& candidates = std::get<std::vector<SurfacePoint>>(sampled);
  const auto kept = eliminate(find_neighbours(split.mesh(), candidates, options), options.count, options.progress);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (kept[i]) points.push_back(split.to_input(candidates[i]));
  }
  return points;
}

}  // namespace gvd
