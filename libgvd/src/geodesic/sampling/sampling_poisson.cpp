// Blue noise by sample elimination: Yuksel, Sample elimination for generating Poisson disk sample sets, 2015, with
// geodesic distances. Start from several random candidates for each point. Remove the candidate with the largest
// weight, again and again, until `count` points are left.
#include "geodesic/sampling/sampling_poisson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/lazy_max_heap.hpp"
#include "geodesic/marching/local_march.hpp"
#include "geodesic/sampling/sampling_mesh.hpp"
#include "geodesic/sampling/sampling_random.hpp"
#include "geodesic/sampling/sampling_spacing.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Candidates for each point (section 3.2 of the paper: five suffice).
constexpr std::int64_t kCandidates = 5;

/// Weight limiting of the paper's equation 3, with the paper's numbers: the distance of a pair counts as at least
/// 2 r_max beta (1 - (N / M)^gamma). N points are chosen out of M candidates, and gamma = 1.5.
constexpr double kBeta = 0.65;

// The parts of the step.
constexpr StepPart kPairs{"sampling", 0, 0.9}, kElimination{"sampling", 0.9, 1};

struct Pair {
  std::int32_t first, second;
  float weight;
};

struct Neighbour {
  std::int32_t candidate;
  float weight;
};

/// The neighbours of every candidate, in one array.
struct Neighbourhoods {
  std::vector<std::size_t> begin;  // where each candidate's list begins, and the end of the last
  std::vector<Neighbour> neighbours;
};

/// The candidates in each face, ascending.
struct FaceLists {
  FaceLists(const Mesh& mesh, const std::vector<SurfacePoint>& candidates)
      : begin(static_cast<std::size_t>(mesh.face_count()) + 1, 0), items(candidates.size()) {
    for (const SurfacePoint& c : candidates) ++begin[c.face.index() + 1];
    for (std::size_t f = 0; f + 1 < begin.size(); ++f) begin[f + 1] += begin[f];
    std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      items[end[candidates[i].face.index()]++] = static_cast<std::int32_t>(i);
    }
  }

  std::vector<std::size_t> begin;
  std::vector<std::int32_t> items;
};

/// The paper's equation 2, with alpha = 8: 1 for coincident points, 0 at `diameter`.
float compute_weight(double distance, double least, double diameter) {
  const double w = 1 - std::max(distance, least) / diameter;
  const double w2 = w * w, w4 = w2 * w2;
  return static_cast<float>(w4 * w4);
}

std::vector<Vec3> compute_positions(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<Vec3> positions;
  for (const SurfacePoint& p : points) positions.push_back(position(mesh, p));
  return positions;
}

/// All pairs of candidates whose geodesic distance is below `diameter`.
class PairFinder {
 public:
  PairFinder(const Mesh& mesh, const std::vector<SurfacePoint>& candidates, Front front)
      : mesh_(mesh),
        candidates_(candidates),
        positions_(compute_positions(mesh, candidates)),
        lists_(mesh, candidates),
        march_(mesh, front),
        seen_(static_cast<std::size_t>(mesh.face_count()), -1) {}

  /// The candidates in the order of their faces. Visiting them in this order keeps memory accesses local.
  const std::vector<std::int32_t>& by_face() const { return lists_.items; }

  /// Calls visit(j, distance) for every candidate j > i whose distance from i is below `diameter`.
  template <class Visit>
  void for_each_after(std::int32_t i, double diameter, Visit visit) {
    march_.run(candidates_[i], diameter);
    for (const VertexId v : march_.reached()) {
      for_each_outgoing(mesh_, v, [&](HalfedgeId h) { visit_face(Mesh::face(h), i, diameter, visit); });
    }
  }

 private:
  template <class Visit>
  void visit_face(FaceId f, std::int32_t i, double diameter, Visit visit) {
    if (seen_[f] == i) return;
    seen_[f] = i;
    for (std::size_t k = lists_.begin[f.index()]; k < lists_.begin[f.index() + 1]; ++k) {
      const std::int32_t j = lists_.items[k];
      if (j <= i) continue;
      // No path is shorter than the straight line through space.
      if ((positions_[i] - positions_[j]).norm() >= diameter) continue;
      const double distance = march_.distance(candidates_[j]);
      if (distance < diameter) visit(j, distance);
    }
  }

  const Mesh& mesh_;
  const std::vector<SurfacePoint>& candidates_;
  std::vector<Vec3> positions_;
  FaceLists lists_;
  LocalMarch march_;
  IdVector<FaceId, std::int32_t> seen_;  // the last candidate whose search visited the face
};

Neighbourhoods join(std::size_t candidates, const std::vector<Pair>& pairs) {
  Neighbourhoods result{std::vector<std::size_t>(candidates + 1, 0), std::vector<Neighbour>(2 * pairs.size())};
  for (const Pair& p : pairs) {
    ++result.begin[static_cast<std::size_t>(p.first) + 1];
    ++result.begin[static_cast<std::size_t>(p.second) + 1];
  }
  for (std::size_t i = 0; i < candidates; ++i) result.begin[i + 1] += result.begin[i];
  std::vector<std::size_t> end(result.begin.begin(), result.begin.end() - 1);
  for (const Pair& p : pairs) {
    result.neighbours[end[p.first]++] = {p.second, p.weight};
    result.neighbours[end[p.second]++] = {p.first, p.weight};
  }
  return result;
}

Neighbourhoods find_neighbours(const Mesh& mesh, const std::vector<SurfacePoint>& candidates, std::int64_t count,
                               const SamplingOptions& options) {
  // The largest spacing that `count` points of the plane can have: the paper's 2 r_max.
  const double diameter = even_spacing(compute_area(mesh), count);
  const double share = static_cast<double>(count) / static_cast<double>(candidates.size());
  const double least = diameter * kBeta * (1 - share * std::sqrt(share));
  PairFinder finder(mesh, candidates, options.front);
  std::vector<Pair> pairs;
  std::int64_t done = 0;
  for (const std::int32_t first : finder.by_face()) {
    report_progress(options.progress, kPairs, double(done++) / double(candidates.size()));
    finder.for_each_after(first, diameter, [&](std::int32_t second, double distance) {
      pairs.push_back({first, second, compute_weight(distance, least, diameter)});
    });
  }
  return join(candidates.size(), pairs);
}

/// Removes the candidate with the largest weight until `count` are left; returns which ones these are.
std::vector<char> eliminate(const Neighbourhoods& lists, std::int64_t count, const Progress& progress) {
  const std::size_t candidates = lists.begin.size() - 1;
  std::vector<double> weight(candidates, 0);
  for (std::size_t i = 0; i < candidates; ++i) {
    for (std::size_t k = lists.begin[i]; k < lists.begin[i + 1]; ++k) weight[i] += double(lists.neighbours[k].weight);
  }
  const auto key = [&](std::int32_t i) { return weight[i]; };
  LazyMaxHeap heap(static_cast<std::int32_t>(candidates), key);
  std::vector<char> kept(candidates, 1);
  for (auto left = static_cast<std::int64_t>(candidates); left > count; --left) {
    report_progress(progress, kElimination, double(std::ssize(kept) - left) / double(std::ssize(kept) - count));
    const auto i = static_cast<std::size_t>(heap.top(key).id);
    heap.pop();
    kept[i] = 0;
    for (std::size_t k = lists.begin[i]; k < lists.begin[i + 1]; ++k) {
      const Neighbour& n = lists.neighbours[k];
      weight[n.candidate] -= double(n.weight);
    }
  }
  return kept;
}

}  // namespace

std::vector<SurfacePoint> sample_poisson(const Mesh& mesh, const SamplingOptions& options) {
  if (options.count > kMaxSamplingVertices) {
    throw Error(ErrorCode::precondition,
                fmt::format("poisson sampling gives at most {} generators; ask for fewer, or for random ones",
                            kMaxSamplingVertices));
  }
  const double longest = kMaxEdgeSpacings * even_spacing(require_area(mesh), options.count);
  const SamplingMesh split(mesh, {longest, 0, max_splits(mesh, options.count)}, options.progress);
  const auto candidates = sample_random(split.mesh(), kCandidates * options.count, options.seed);
  const auto kept =
      eliminate(find_neighbours(split.mesh(), candidates, options.count, options), options.count, options.progress);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (kept[i]) points.push_back(split.to_input(candidates[i]));
  }
  return points;
}

}  // namespace gvd
