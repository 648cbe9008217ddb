#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A face as window propagation sees it: what it takes to carry an image across the face without a division by a length
/// or an angle. 96 bytes, one and a half lines of the cache.
struct FaceFrame {
  std::array<double, 3> length;        ///< of halfedge i, mesh units
  std::array<double, 3> cosine;        ///< of the angle at corner i
  std::array<double, 3> sine;          ///< of the angle at corner i, >= 0
  std::array<std::int32_t, 3> vertex;  ///< at corner i
  std::array<std::int32_t, 3> twin;    ///< of halfedge i, or -1 on the boundary
};
static_assert(sizeof(FaceFrame) == 96);

FaceFrame make_face_frame(const Mesh& mesh, FaceId f);

/// What the total angle theta of the faces round a vertex means for shortest paths.
enum class VertexKind : std::uint8_t {
  plain,   ///< convex, or on the boundary with theta <= pi: no shortest path goes through it but at its end
  flat,    ///< theta = 2 pi: paths go straight on; the images that its two sides see are one
  saddle,  ///< theta > 2 pi: a pseudo-source
  reflex,  ///< on the boundary with theta > pi: a pseudo-source
  /// One of needles, so that rounding hides on which side of straight theta lies, and opens gaps between the windows
  /// that pass on both sides of it: a pseudo-source in all directions, which is never wrong.
  ambiguous,
};

/// An angle this close to 2 pi (or pi, on the boundary), in radians, is taken for it. The sum of a dozen angles is
/// right to 1e-14. Behind a saddle that is taken for flat lies a wedge of this angle that no window reaches; what lies
/// in it is found by kGrazingAngle, where no more than a thousand of them are in one line.
inline constexpr double kFlatAngle = 1e-12;

/// Error of a length along an edge, relative to the edge: a few dozen roundings.
inline constexpr double kRounding = 1e-14;

struct FaceFrames {
  IdVector<FaceId, FaceFrame> frame;
  IdVector<VertexId, VertexKind> kind;
  /// Whether a face is a needle: then paths through different faces tie all over, and what costs time or memory to keep
  /// such windows down is worth it.
  bool has_needles = false;
  /// Whether a face is so thin that windows might wind round it often: a path that meets faces again is then looked
  /// for, and so are gaps that rounding leaves between windows.
  bool has_thin_faces = false;
  /// Of all corners; what rounding does to the directions of paths is kRounding over it.
  double least_sine = 1;

  /// Cost: O(n), no trigonometry.
  FaceFrames(const Mesh& mesh, const ParallelChunks& parallel);
  /// The same on one thread.
  explicit FaceFrames(const Mesh& mesh);
};

}  // namespace gvd
