#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/window.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A part of the mesh that one thread works on at a time (mesh_partitions.hpp).
using PartitionId = Id<struct PartitionTag>;

/// A vertex as one partition knows it. A vertex whose faces lie in several partitions has a copy in each of them; its
/// first copy has the number of the vertex, further ones are numbered beyond the last vertex.
using VertexCopyId = Id<struct VertexCopyTag>;

/// A copy of a vertex that several partitions have. Only such copies are numbered.
using SharedCopyId = Id<struct SharedCopyTag>;

inline VertexCopyId first_copy(VertexId v) { return VertexCopyId(v.value()); }

/// A face as window propagation sees it: all that it takes to carry an image across the face without dividing by a
/// length or computing an angle. It takes 96 bytes, one and a half cache lines.
struct FaceFrame {
  std::array<double, 3> length;        ///< the length of halfedge i, mesh units
  std::array<double, 3> cosine;        ///< the cosine of the angle at corner i
  std::array<double, 3> sine;          ///< the sine of the angle at corner i, >= 0
  std::array<VertexCopyId, 3> vertex;  ///< at corner i; the first copies, until the mesh is cut into partitions
  std::array<HalfedgeId, 3> twin;      ///< the twin of halfedge i; invalid on the boundary
};
static_assert(sizeof(FaceFrame) == 96);

FaceFrame make_face_frame(const Mesh& mesh, FaceId f);

/// The meaning of the total angle theta of a vertex's faces for shortest paths.
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
  /// Whether any face is a needle. Paths through different faces then tie in many places, so that filters that cost
  /// time or memory are worth it.
  bool has_needles = false;
  /// Whether any face is thin, so that windows might wind round it many times. Propagation then looks for paths that
  /// enter a face twice, and for gaps that rounding leaves between windows.
  bool has_thin_faces = false;
  /// Least sine of all corners. Rounding turns the directions of paths by up to kPositionRounding divided by it.
  double least_sine = 1;

  /// Cost: O(n), no trigonometry.
  FaceFrames(const Mesh& mesh, const ParallelChunks& parallel);

  /// Follows a change of the mesh in which only these faces and their vertices have changed. Afterwards their corners
  /// refer to first copies again. `least_sine` is not updated; the caller sets it by `set_least_sine`.
  /// Cost: O(faces of their vertices).
  void update(const Mesh& mesh, std::span<const FaceId> changed);
  /// The least sine of the corners of a face.
  double least_sine_of(FaceId f) const { return std::ranges::min(frame[f].sine); }
  /// Sets the least sine, and what depends on it.
  void set_least_sine(double least);
};

/// The angles of all corners, and of the sides round each vertex, as departures count them.
class CornerAngles {
 public:
  CornerAngles() = default;
  /// Cost: O(n).
  CornerAngles(const Mesh& mesh, const FaceFrames& frames, const ParallelChunks& parallel);

  bool empty() const { return corner_.empty(); }
  /// The angle of the corner that a halfedge leaves.
  Departure corner(HalfedgeId h) const { return corner_[h]; }
  /// The angle of a halfedge round the vertex that it leaves, counter-clockwise from `mesh.halfedge` of that vertex. It
  /// is used for generators.
  Departure side(HalfedgeId h) const { return side_[h]; }

 private:
  IdVector<HalfedgeId, Departure> corner_, side_;
};

}  // namespace gvd
