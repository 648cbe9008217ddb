#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

// The ways of `sample_generators`, and the random numbers, faces and vertices that they draw.
namespace gvd {

/// Least distance between two points of a sampling, as a fraction of the bounding box's diagonal. Below kCoincidence,
/// which has the same value, the library takes two generators for one.
inline constexpr double kMinSampleSpacing = 1e-12;

/// Number of points between two reports of progress, if each point takes a few look-ups.
inline constexpr std::size_t kSweepStride = 1 << 12;

/// Edges longer than this many even spacings are split before sampling: then a generator fits between their ends, and
/// a face holds only a few candidates.
inline constexpr double kMaxEdgeSpacings = 2;

/// Points, or why the surface has no room for as many.
using SampledPoints = OrError<std::vector<SurfacePoint>>;

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

  /// Draws one of the faces [first, last) of the list; the last of them if all their areas are 0.
  FaceId draw_face(SeededRandom& random, std::size_t first, std::size_t last) const;
  /// Draws a point inside a face, uniformly by area.
  SurfacePoint draw_point(SeededRandom& random) const;

 private:
  std::vector<FaceId> faces_;
  std::vector<double> sums_;  // sums_[i]: area of the faces before faces_[i]; back(): of all faces
};

/// All faces in the order of their ids.
std::vector<FaceId> list_faces(const Mesh& mesh);

/// The area of the mesh, which must be finite and > 0. Throws Error{precondition} otherwise.
double require_area(const Mesh& mesh);

/// Draws `count` different vertices, each with the same probability, and returns them in the order in which they were
/// drawn. `count` is from 0 to the number of vertices. The result is the beginning of a random permutation, so that a
/// smaller count gives the first of the same vertices.
/// Cost: O(n).
std::vector<VertexId> draw_vertices(const Mesh& mesh, std::int64_t count, std::uint64_t seed);

/// Draws `count` points inside faces, uniformly by area, no two of which are closer than kMinSampleSpacing.
/// Throws Error{precondition} if the area is 0 or not finite.
SampledPoints sample_random(const Mesh& mesh, std::int64_t count, const SamplingOptions& options);

/// Sampling::poisson: `count` points with blue-noise spacing. The caller has checked the options.
SampledPoints sample_poisson(const Mesh& mesh, const SamplingOptions& options);

/// Sampling::farthest: `count` vertices, each the farthest from all before it. The caller has checked the options.
SampledPoints sample_farthest(const Mesh& mesh, const SamplingOptions& options);

/// Sampling::covering_radius: farthest vertices until no point is farther than `radius` from its nearest generator.
/// The caller has checked the options.
std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options);

}  // namespace gvd
