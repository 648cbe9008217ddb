#pragma once

#include <optional>
#include <vector>

#include "gvd/features.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// What restricts generators before and while they are relaxed.
struct StartOptions {
  /// The points were listed, and stay where they are. Otherwise they were sampled, and make room for those on features.
  bool are_listed = false;
  std::vector<SurfacePoint> fixed;     ///< further generators, which stay where they are; no two of them coincide
  std::optional<double> crease_angle;  ///< generators keep to sharper edges, degrees in (0, 180]; nothing: to none
  bool keep_boundary = false;          ///< generators keep to the boundary, too
  bool prefers_boundary = false;       ///< sampled ones do, as long as enough of them are left beside it
};

/// Generators to begin a relaxation with, and what they may do: see the fields of LloydOptions.
struct ConstrainedStart {
  std::vector<SurfacePoint> points;
  std::vector<Freedom> freedom;  ///< of the points; empty if all are free
  std::vector<EdgeId> creases;
  double corner_distance = 0;  ///< of the creases (place_on_creases), mesh units
};

/// The start of a relaxation with fixed generators, and with generators on creases and on the boundary.
///
/// Fixed generators come first, then those on features, then the rest of `points`. Sampled ones make room, each the
/// nearest one, for those that are fixed or lie on features, so that their number stays. Listed ones stay, and those on
/// creases are kept there. Those on features are at most four fifths of all, as far as corners and closed creases do
/// not need more. Of the others, those that coincide with an earlier one are left out. Without any restriction, the
/// start is `points`. The faces of all points must be of `mesh`.
/// Throws Error{precondition} where fewer points are sampled than generators are fixed or on features, and
/// Error{invalid_option} for an angle out of its range. Cost: O(n log n), as long as few points have the same x.
ConstrainedStart constrain_start(const Mesh& mesh, std::vector<SurfacePoint> points, const StartOptions& options);

}  // namespace gvd
