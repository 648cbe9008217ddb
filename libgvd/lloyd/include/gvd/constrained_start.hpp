#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The usual angle of preferred creases, in degrees. All creases of CAD models are sharper, but few edges of scans.
inline constexpr double kUsualCreaseAngle = 40;

/// Constraints of generators before and during a relaxation.
struct StartOptions {
  /// Whether the points were listed, and stay where they are. Otherwise they were sampled, and may be removed to make
  /// room for generators on features.
  bool are_listed = false;
  std::vector<SurfacePoint> fixed;  ///< further generators, which never move; no two may coincide
  /// Keep generators on edges sharper than this, degrees in (0, 180]; nothing: no creases.
  std::optional<double> crease_angle;
  /// Only sampled generators follow creases, and only as `constrain_start` describes.
  bool prefers_creases = false;
  bool keep_boundary = false;  ///< keep generators on the boundary
  /// Only sampled generators follow the boundary, and only as `constrain_start` describes.
  bool prefers_boundary = false;
  /// If there are creases, sample fewer generators by the number that a remesh is expected to add on close curves.
  bool leaves_room = false;
  Progress progress;  ///< may be empty
};

/// The initial generators of a relaxation, and how they may move (see the fields of LloydOptions).
struct ConstrainedStart {
  std::vector<SurfacePoint> points;
  std::vector<Freedom> freedom;  ///< for each point; empty if all are free
  std::vector<EdgeId> creases;
  double corner_distance = 0;         ///< for `trace_creases`, mesh units
  std::int64_t loops = 0;             ///< number of boundary loops, if the boundary is preferred
  std::int64_t unfollowed_loops = 0;  ///< number of loops not followed because they would take too many generators
  std::int64_t enough_for_loops = 0;  ///< how many generators would follow all loops; 0 if all are followed
  /// Whether preferred creases are not followed, because they would take too many generators.
  bool leaves_creases = false;
  /// How many generators would follow the creases; 0 if even ten times as many would not.
  std::int64_t enough_for_creases = 0;
};

/// Prepares a relaxation: adds fixed generators, and places generators on creases and on the boundary.
///
/// Fixed generators come first, then generators on features (creases and boundary), then the rest of `points`. For each
/// generator that is fixed or on a feature, the nearest sampled generator is removed, so that the number stays the
/// same. Listed generators stay, and if they lie on creases they are kept there. Generators on features are as far
/// apart as in an even triangulation of the surface; they are at most half of all generators, unless corners and closed
/// creases need more, or they are all on the boundary and an even triangulation has more there. Points that coincide
/// with an earlier generator are left out. Without any constraint, the start is `points`. All points must lie in faces
/// of `mesh`.
///
/// Sampled generators follow a preferred boundary if at most half of them suffice: one at each of its corners, and
/// three on a loop without corners. Otherwise they follow only the loops that are at least three spacings long, or
/// none. They follow preferred creases if at most half of them suffice at their spacing, including the generators on
/// the boundary and the ones that a remesh is expected to add, which may be 12 % of all. Noise, small details and
/// rounded edges do not count: a connected group of creases must be at least three spacings long, crisp (see
/// CreaseChains), and three spacings longer for each of its ends and turns. At least half of the length of all creases
/// has to be in such groups.
///
/// Returns Error{precondition} if there are fewer sampled points than generators that are fixed or on features. Throws
/// Error{interrupted} if the progress callback cancels, and Error{invalid_option} for an angle out of range. Cost:
/// O(n log n), as long as few points have the same x coordinate.
OrError<ConstrainedStart> constrain_start(const Mesh& mesh, std::vector<SurfacePoint> points,
                                          const StartOptions& options);

}  // namespace gvd
