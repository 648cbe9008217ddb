#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The usual angle of creases that are preferred, degrees. All creases of CAD models are sharper, few edges of scans.
inline constexpr double kUsualCreaseAngle = 40;

/// Restrictions of generators before and while they are relaxed.
struct StartOptions {
  /// The points were listed, and stay where they are. Otherwise they were sampled, and make room for those on features.
  bool are_listed = false;
  std::vector<SurfacePoint> fixed;     ///< further generators, which stay where they are; no two of them coincide
  std::optional<double> crease_angle;  ///< generators keep to sharper edges, degrees in (0, 180]; nothing: to none
  bool prefers_creases = false;        ///< sampled ones keep to these, as far as constrain_start says
  bool keep_boundary = false;          ///< generators keep to the boundary, too
  bool prefers_boundary = false;       ///< sampled ones do, as far as constrain_start says
  /// Where there are creases, sampled ones leave out as many as a remesh is expected to add on close curves.
  bool leaves_room = false;
  Progress progress;  ///< may be empty
};

/// Generators to begin a relaxation with, and what they may do: see the fields of LloydOptions.
struct ConstrainedStart {
  std::vector<SurfacePoint> points;
  std::vector<Freedom> freedom;  ///< of the points; empty if all are free
  std::vector<EdgeId> creases;
  double corner_distance = 0;           ///< of the creases (trace_creases), mesh units
  std::int64_t loops = 0;               ///< of the boundary, where it is preferred
  std::int64_t unfollowed_loops = 0;    ///< of these, those that would take too many generators
  std::int64_t enough_for_loops = 0;    ///< with so many generators some are on each loop; 0 where all are followed
  bool leaves_creases = false;          ///< creases are preferred, and would take too many generators
  std::int64_t enough_for_creases = 0;  ///< so many would follow them; 0 where no number up to ten times as many does
};

/// The start of a relaxation with fixed generators, and with generators on creases and on the boundary.
///
/// Fixed generators come first, then those on features, then the rest of `points`. Sampled ones make room, each the
/// nearest one, for those that are fixed or lie on features, so that their number stays. Listed ones stay, and those on
/// creases are kept there. Those on features are as far apart as in an even triangulation of the surface; they are at
/// most half of all, as far as corners and closed creases do not need more, and an even triangulation has no more on
/// the boundary. Of the others, those that coincide with an earlier one are left out. Without any restriction, the
/// start is `points`. The faces of all points must be of `mesh`.
///
/// Sampled generators keep to a boundary that is preferred if at most half of them suffice: at its corners, and three
/// on a loop without. If not, they keep to the loops that are at least three spacings long, or to none. They keep to
/// creases that are preferred if at most half of them suffice at their spacing, those on the boundary and those that a
/// remesh is expected to add included; the latter may be 12 % of all. Noise and small details are no such creases: a
/// connected network counts if it is three spacings long, and has a dead end in 20 spacings of its length at most. At
/// least half of the length of all creases has to be in such networks.
///
/// Throws Error{interrupted} if the progress callback cancels, Error{precondition} where fewer points are sampled than
/// generators are fixed or on features, and Error{invalid_option} for an angle out of its range. Cost: O(n log n), as
/// long as few points have the same x.
ConstrainedStart constrain_start(const Mesh& mesh, std::vector<SurfacePoint> points, const StartOptions& options);

}  // namespace gvd
