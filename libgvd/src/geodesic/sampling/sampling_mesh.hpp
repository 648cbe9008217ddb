#pragma once

#include <array>
#include <cstdint>

#include "base/barycentric.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

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
  /// The same point as a point of the input.
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

/// The largest number of vertices that splitting long edges may add. It is proportional to the number of vertices and
/// generators together. It limits the memory if faces are thin, and has no effect otherwise.
std::int64_t max_splits(const Mesh& mesh, std::int64_t count);

}  // namespace gvd
