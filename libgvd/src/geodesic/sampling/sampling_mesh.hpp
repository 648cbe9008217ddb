#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

struct SplitOptions {
  double longest;      ///< edges longer than this are split; mesh units, > 0
  std::int64_t least;  ///< the longest edges are split until there are so many vertices in all
  std::int64_t most;   ///< splits for the sake of length add at most so many vertices
};

/// The mesh that a sampling works on: the input, or a copy whose long edges are split at their midpoints.
///
/// The surface stays as it is; each split halves the longest edge of all, and with it the longest edge of its two
/// faces, so no angle falls below half of what it was in the face where it comes from (Rosenberg and Stenger, 1975).
/// Where nothing is to be split, this is the input itself and nothing is allocated.
class SamplingMesh {
 public:
  /// Splits the longest edge as long as the options ask for it; ties go to the least edge id.
  /// Cost: O((n + k) log n) for k vertices added.
  SamplingMesh(const Mesh& input, const SplitOptions& options, const Progress& progress);

  const Mesh& mesh() const { return split_ ? copy_ : *input_; }
  /// The same point on the input.
  SurfacePoint to_input(const SurfacePoint& point) const;
  SurfacePoint to_input(VertexId v) const;

 private:
  using Corners = std::array<std::array<double, 3>, 3>;
  struct Part {
    FaceId parent;    // of the input
    Corners corners;  // in the parent's barycentric coordinates
  };

  void copy_input();
  void split(EdgeId e);
  void split_part(HalfedgeId h, FaceId appended);

  const Mesh* input_;
  bool split_ = false;
  Mesh copy_;
  IdVector<FaceId, Part> parts_;
};

/// Length of the longest edge, in mesh units. Cost: O(n).
double longest_edge(const Mesh& mesh);

}  // namespace gvd
