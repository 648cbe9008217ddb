#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/geometry/propagation_ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A face as window propagation sees it: all that it takes to carry an image across the face without dividing by a
/// length or computing an angle. 96 bytes, one and a half lines of the cache.
struct FaceFrame {
  std::array<double, 3> length;        ///< of halfedge i, mesh units
  std::array<double, 3> cosine;        ///< of the angle at corner i
  std::array<double, 3> sine;          ///< of the angle at corner i, >= 0
  std::array<VertexCopyId, 3> vertex;  ///< at corner i; the first copies, until the mesh is cut into partitions
  std::array<HalfedgeId, 3> twin;      ///< of halfedge i; invalid on the boundary
};
static_assert(sizeof(FaceFrame) == 96);

FaceFrame make_face_frame(const Mesh& mesh, FaceId f);

/// What the total angle theta of the faces round a vertex means for shortest paths.
enum class VertexKind : std::uint8_t {
  plain,   ///< convex, or on the boundary with theta <= pi: no shortest path passes through it
  flat,    ///< theta = 2 pi: paths pass straight through; the windows on its two sides have one image
  saddle,  ///< theta > 2 pi: a pseudo-source
  reflex,  ///< on the boundary with theta > pi: a pseudo-source
  /// A vertex of needles: rounding hides whether theta is more or less than straight, and opens gaps between the
  /// windows that pass on its two sides. It is a pseudo-source in all directions, which is always correct.
  ambiguous,
};

/// An angle within this distance of 2 pi (or of pi, on the boundary), in radians, counts as equal to it. The sum of a
/// dozen angles has an error of 1e-14. Behind a saddle that is taken for flat lies a wedge of this angle that no window
/// covers. Vertices in it are found by kGrazingAngle, unless a thousand such saddles lie on one line.
inline constexpr double kFlatAngle = 1e-12;

/// Error of a position along an edge, relative to the edge's length: a few dozen roundings.
inline constexpr double kPositionRounding = 1e-14;

struct FaceFrames {
  IdVector<FaceId, FaceFrame> frame;
  IdVector<VertexCopyId, VertexKind> kind;
  /// Whether a face is a needle. Paths through different faces then tie in many places, and filters that cost time or
  /// memory are worth it.
  bool has_needles = false;
  /// Whether a face is thin: windows might wind round it many times. Paths that enter a face twice, and gaps that
  /// rounding leaves between windows, are then looked for.
  bool has_thin_faces = false;
  /// Least sine of all corners. Rounding turns the directions of paths by up to kPositionRounding over it.
  double least_sine = 1;

  /// Cost: O(n), no trigonometry.
  FaceFrames(const Mesh& mesh, const ParallelChunks& parallel);
  /// The same on one thread.
  explicit FaceFrames(const Mesh& mesh);
};

}  // namespace gvd
