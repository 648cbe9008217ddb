#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geodesic/marching/local_march.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Edges longer than this many even spacings are split before sampling: then a generator fits between their ends, and
/// a face holds only a few candidates.
inline constexpr double kMaxEdgeSpacings = 2;

/// The largest number of vertices that splitting long edges may add. The number is proportional to the mesh and to the
/// generators. It bounds the memory where faces are thin, and takes effect nowhere else.
std::int64_t max_splits(const Mesh& mesh, std::int64_t count);

/// `count` different vertices, each with the same probability, in the order in which they were drawn; `count` from 0 to
/// the number of vertices. The beginning of a random permutation, so that a smaller count gives the first ones of
/// these.
/// Cost: O(n).
std::vector<VertexId> draw_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed);

/// The same as surface points. Throws Error{precondition} if the mesh has fewer vertices.
std::vector<SurfacePoint> sample_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed);

/// Sampling::farthest: `count` vertices, each the farthest from all before it. The caller has checked the options.
std::vector<SurfacePoint> sample_farthest(const Mesh& mesh, const SamplingOptions& options);

/// Sampling::covering_radius: farthest vertices until no point is farther than `radius` from its nearest generator.
/// The caller has checked the options.
std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options);

/// Sampling::poisson: `count` points with blue-noise spacing. The caller has checked the options.
std::vector<SurfacePoint> sample_poisson(const Mesh& mesh, const SamplingOptions& options);

/// An upper bound on the distance of every point p of a triangle, from the distances of its corners: the maximum over p
/// of min over corners i of distance[i] + |p - corner i|.
///
/// Inputs:  distances in mesh units. Those of two corners differ by at most the length of their side (triangle
///   inequality).
/// Returns: mesh units; in [largest distance, largest distance + longest side / sqrt(3)].
/// Properties: (1) non-decreasing in each distance; (2) symmetric in the corners; (3) attained if the path to each corner
///   continues the segment from p to that corner.
/// Cost: O(1), a square root.
double compute_face_distance_bound(const FaceShape& face, const std::array<double, 3>& distance);

/// The nearest of the generators inserted so far, at every vertex.
///
/// An insertion updates only the vertices that are nearest to the new generator, so N insertions cost about
/// O(n log n log N) in all. Of two generators at the same distance the earlier one is kept.
class NearestField {
 public:
  NearestField(const Mesh& mesh, Front front)
      : march_(mesh, front), distance_(mesh.vertex_count(), kInfinity), label_(mesh.vertex_count()) {}

  /// Adds the next generator. Cost: O(k log k) for the k vertices that are nearest to it.
  GeneratorId insert(const SurfacePoint& point) {
    const GeneratorId g(count_++);
    march_.run(point, kInfinity, &distance_);
    for (const VertexId v : march_.reached()) {
      const double d = march_.distance(v);
      if (!(d < distance_[v])) continue;
      distance_[v] = d;
      label_[v] = g;
    }
    return g;
  }

  /// See LocalMarch::watch_runs.
  void watch_insertions(std::function<void(std::size_t reached)> watch) { march_.watch_runs(std::move(watch)); }

  /// Mesh units; infinity where no generator reaches.
  double distance(VertexId v) const { return distance_[v]; }
  /// Invalid where no generator reaches.
  GeneratorId label(VertexId v) const { return label_[v]; }

 private:
  LocalMarch march_;
  IdVector<VertexId, double> distance_;
  IdVector<VertexId, GeneratorId> label_;
  std::int32_t count_ = 0;
};

}  // namespace gvd
