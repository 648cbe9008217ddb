#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "geodesic/marching/local_march.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

// The ways of `sample_generators`, and what they share: random numbers, a mesh with short edges, and a field of the
// nearest generators.
namespace gvd {

/// Least distance between two points of a sampling, as a fraction of the bounding box's diagonal. Below kCoincidence,
/// which has the same value, the library takes two generators for one.
inline constexpr double kMinSampleSpacing = 1e-12;

/// Random numbers that are the same on every platform. The C++ standard specifies the output of the engine, but not
/// that of the distributions.
class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : engine_(seed) {}
  /// A number in [0, 1), a multiple of 2^-53.
  double real() { return double(engine_() >> 11) * 0x1p-53; }
  /// A number in [0, n), for n > 0; uniform up to a relative 2^-64 n.
  std::size_t below(std::size_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_;
};

/// Draws faces with a probability proportional to their area.
class AreaSampler {
 public:
  /// Draws from all faces of `mesh`, in the order of `faces`.
  AreaSampler(const Mesh& mesh, std::vector<FaceId> faces);

  /// One of the faces [first, last) of the list; the last one if all their areas are 0.
  FaceId draw_face(SeededRandom& random, std::size_t first, std::size_t last) const;
  /// A point inside any face, uniform by area.
  SurfacePoint draw_point(SeededRandom& random) const;

 private:
  std::vector<FaceId> faces_;
  std::vector<double> sums_;  // sums_[i]: area of the faces before faces_[i]; back(): of all faces
};

/// All faces in order.
std::vector<FaceId> list_faces(const Mesh& mesh);

/// The area of the mesh, which must be finite and > 0. Throws Error{precondition} otherwise.
double require_area(const Mesh& mesh);

struct SplitOptions {
  double max_edge_length;     ///< longer edges are split; mesh units, > 0
  std::int64_t min_vertices;  ///< the longest edges are split until the mesh has this many vertices
  std::int64_t max_added;     ///< splitting edges for their length adds at most this many vertices
};

/// The mesh that a sampling works on: the input, or a copy whose long edges are split at their midpoints.
///
/// The surface does not change. Each split halves the longest edge of the mesh, which is the longest of its faces, too.
/// Every angle therefore stays at least half of the smallest angle of its parent face (Rosenberg and Stenger, 1975).
/// If no edge needs to be split, mesh() is the input and nothing is allocated.
class SamplingMesh {
 public:
  /// Splits the longest edge, the one with the least id among equals, until the options are satisfied.
  /// Cost: O((n + k) log n) for k vertices added.
  SamplingMesh(const Mesh& input, const SplitOptions& options, const Progress& progress);

  const Mesh& mesh() const { return split_ ? copy_ : *input_; }
  /// The same point on the input.
  SurfacePoint to_input(const SurfacePoint& point) const;
  SurfacePoint to_input(VertexId v) const;

 private:
  /// A face of the copy.
  struct SubFace {
    FaceId parent;                // the input face that contains it
    std::array<Bary, 3> corners;  // in the parent's barycentric coordinates
  };

  double share_done(const SplitOptions& options, double longest) const;
  void split(EdgeId e);
  void split_subface(HalfedgeId h, FaceId appended);

  const Mesh* input_;
  bool split_ = false;
  Mesh copy_;
  IdVector<FaceId, SubFace> subfaces_;
};

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

/// Sampling::farthest: `count` vertices, each the farthest from all before it. The caller has checked the options.
std::vector<SurfacePoint> sample_farthest(const Mesh& mesh, const SamplingOptions& options);

/// Sampling::covering_radius: farthest vertices until no point is farther than `radius` from its nearest generator.
/// The caller has checked the options.
std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options);

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

/// Distance of every vertex from the nearest of the generators inserted so far.
///
/// An insertion updates only the vertices that are nearest to the new generator, so N insertions cost about
/// O(n log n log N) in all.
class NearestField {
 public:
  NearestField(const Mesh& mesh, Front front, const Progress& progress = {})
      : march_(mesh, front, progress), distance_(mesh.vertex_count(), kInfinity) {}

  /// Adds the next generator. Cost: O(k log k) for the k vertices that are nearest to it.
  void insert(const SurfacePoint& point) {
    march_.run(point, kInfinity, &distance_);
    for (const PlaceId p : march_.reached()) distance_[p] = std::min(distance_[p], march_.distance(p));
  }

  /// See LocalMarch::watch_runs.
  void watch_insertions(std::function<void(std::size_t reached)> watch) { march_.watch_runs(std::move(watch)); }

  const MarchFans& fans() const { return march_.fans(); }
  /// Mesh units; infinity where no generator reaches.
  double distance(PlaceId p) const { return distance_[p]; }
  double distance(VertexId v) const { return distance_[fans().place(v)]; }

 private:
  LocalMarch march_;
  IdVector<PlaceId, double> distance_;
};

}  // namespace gvd
