#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_distance.hpp"

namespace gvd {
namespace {

/// Elements whose closest points one thread finds at a time, each near that of the one before.
constexpr std::size_t kPerChunk = 128;

IdVector<FaceId, std::int32_t> choose_steps(const Mesh& mesh) {
  IdVector<FaceId, std::int32_t> steps;
  const double area = compute_area(mesh);
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const double share = area > 0 ? mesh.area(FaceId(i)) / area : 0;
    const double wanted = std::floor(std::sqrt(share * kSampledTriangles));
    steps.push_back(static_cast<std::int32_t>(std::clamp(wanted, 1.0, double{DistanceSamples::kMaxSteps})));
  }
  return steps;
}

/// Distances of points from a mesh, each search from the face nearest to the point before.
class Probe {
 public:
  explicit Probe(const ClosestPointTree& tree) : tree_(tree) {}

  double operator()(const Vec3& point) {
    const NearestFace nearest = tree_.nearest_face(point, near_);
    near_ = nearest.face;
    return nearest.distance;
  }

 private:
  const ClosestPointTree& tree_;
  FaceId near_ = FaceId(0);
};

void sample_lattice(const Mesh& mesh, FaceId f, std::int32_t k, Probe& probe, std::vector<double>& samples) {
  if (k < 2) return;
  const auto& [a, b, c] = mesh.vertices(f);
  for (std::int32_t i = 0; i <= k; ++i) {
    for (std::int32_t j = 0; j <= k - i; ++j) {
      const double s = double(i) / k, t = double(j) / k, r = double(k - i - j) / k;
      samples.push_back(probe(s * mesh.position(a) + r * mesh.position(b) + t * mesh.position(c)));
    }
  }
}

}  // namespace

DistanceSamples sample_surface_distance(const Mesh& from, const Mesh& to, int threads) {
  if (from.face_count() == 0 || to.face_count() == 0) {
    throw Error(ErrorCode::precondition, "a mesh without faces has no distance from another one");
  }
  const ClosestPointTree tree(to);
  const Progress none;
  const ParallelChunks parallel(threads, none);
  DistanceSamples result;
  result.steps = choose_steps(from);
  const auto collect = [&](std::int32_t count, const auto& add) {
    const auto chunks = cut_into_chunks(static_cast<std::size_t>(count), kPerChunk);
    return parallel.collect(chunks, {}, [&](const Chunk& chunk) {
      std::vector<double> samples;
      Probe probe(tree);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) add(static_cast<std::int64_t>(i), probe, samples);
      return samples;
    });
  };
  result.at_vertex = IdVector<VertexId, double>(
      collect(from.vertex_count(), [&](std::int64_t i, Probe& probe, std::vector<double>& samples) {
        samples.push_back(probe(from.position(VertexId(i))));
      }));
  result.lattice = collect(from.face_count(), [&](std::int64_t i, Probe& probe, std::vector<double>& samples) {
    sample_lattice(from, FaceId(i), result.steps[FaceId(i)], probe, samples);
  });
  return result;
}

}  // namespace gvd
