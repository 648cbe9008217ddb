#pragma once

#include <cmath>
#include <cstdint>

#include "geodesic/windows/window.hpp"
#include "gvd/vec.hpp"

namespace gvd {

// Rules that drop windows, or sides of them, that hold no shortest path. Each rule is valid for any upper bounds on the
// vertices' distances that are lengths of real paths. The order in which windows are propagated therefore changes no
// result.

// Three fractions of a path's length define when lengths differ: kLengthRounding < kSameLength < kDropClearance. The
// table at kSameImage (window.hpp) gives the rounding error of one path. Two paths differ by at most twice as much.

/// A path must be shorter by this fraction of its length to drop a window. The path of a window through a vertex ties
/// with the vertex's own path. Rounding must not drop that window, because the vertex may send none.
///
/// Beyond two edges from the generator, where rounding begins to count, is_shorter requires at least half of this
/// fraction. Half of it, 5e-14, is the largest difference by rounding of two paths over 400 equal faces. Over 1000
/// unlike faces the difference is 2.7e-14.
inline constexpr double kDropClearance = 1e-13;

/// A distance counts as improved if it falls by more than this fraction of itself. Paths of equal length over 40 faces
/// differ by less. Over more faces, some paths are propagated again, which only costs time.
inline constexpr double kLengthRounding = 4e-15;

/// Whether a path of length `d` is shorter than one of length `known`, and not by rounding alone.
inline bool is_shorter_beyond_rounding(double d, double known) { return d < known * (1 - kLengthRounding); }

/// Paths whose lengths differ by less than this fraction of themselves count as equally long. Equally long paths of
/// different generators differ by less over 150 equal faces, or over 500 unlike faces. Over more faces, rounding may
/// decide the tie.
///
/// The value is below half of kDropClearance, so that no window is dropped before it has offered a path that is equally
/// long. It is above kLengthRounding, so that a tie goes to the first generator even if its path is longer by rounding.
inline constexpr double kSameLength = 2e-14;
static_assert(kLengthRounding < kSameLength && kSameLength < kDropClearance / 2);

/// The order of paths to one vertex, which decides ties: by length, then by generator. Lengths that differ by less than
/// kSameLength are equal. Returns whether a path of length `d` from `generator` precedes the known one, whose generator
/// is `label`. If both paths come from the same generator, the new one must be shorter beyond rounding.
///
/// Paths from several generators tie on symmetric meshes. Neither rounding nor the order in which windows are
/// propagated may decide there: neighbouring vertices would get labels that contradict each other.
inline bool is_before(double d, GeneratorId generator, double known, GeneratorId label) {
  if (!(d * (1 - kSameLength) < known)) return false;  // the most frequent case
  if (d < known * (1 - kSameLength)) return true;
  return is_shorter_beyond_rounding(d, known) ? generator <= label : generator < label;
}

/// Whether a window has no width, or its paths run along the edge.
inline bool is_empty(const Window& w) { return !(w.begin < w.end) | !(w.depth > 0); }

/// Whether a path of length `through` + `step` is shorter than one of length `offset` + sqrt(squared), and not by
/// rounding alone. This takes no square root: (through + step - offset)^2 < squared.
inline bool is_shorter(double through, double step, double offset, double squared) {
  const double rest = through * (1 + kDropClearance) + step - offset;
  return rest * std::abs(rest) < squared * (1 - kDropClearance);  // true for a negative rest
}

/// Whether the path through the start of the edge is shorter than the window's path at all points of the window.
///
/// Proof: let it be shorter at the interval's end B: d + |vB| < s + |IB|, v being the edge's start. For a point P of
/// the interval, |vP| = |vB| - |PB| (P lies between v and B on one line) and |IP| >= |IB| - |PB|, so d + |vP| < s +
/// |IB| - |PB| <= s + |IP|.
inline bool is_beaten_by_start(const Window& w, double start_distance) {
  return is_shorter(start_distance, w.end, w.offset, w.squared_image_distance(w.end));
}

/// The same from the end of the edge, which is `length` long.
inline bool is_beaten_by_end(const Window& w, double end_distance, double length) {
  return is_shorter(end_distance, length - w.begin, w.offset, w.squared_image_distance(w.begin));
}

/// Whether the path through an end of the edge is shorter than a window's path, or longer by rounding alone. That path
/// has the length `end_distance` up to the end of the edge, and `step` from there to the far end of the interval.
/// `offset` is the window's offset, and `squared` the squared distance of its image from the far end. If the end is an
/// ambiguous vertex, which sends windows in all directions, the window can be dropped.
///
/// Proof: as for is_beaten_by_start, the path through the vertex is at most kLengthRounding longer at all points of the
/// interval, and so at all points behind it. The vertex sends a window whose path is no longer than that. Its windows
/// start nearer to these points, so windows and vertices can't drop each other in a circle. Without this rule, in a
/// thin tube of needles, each vertex causes as many windows as the tube has vertices.
inline bool is_left_to_vertex(double offset, double end_distance, double step, double squared) {
  const double rest = (end_distance + step) * (1 - kLengthRounding) - offset;
  return rest * std::abs(rest) < squared;
}

/// Whether a window that has crossed this many faces makes the last of them its cycle_check_face. This holds for powers
/// of two.
inline bool is_cycle_check_step(std::uint32_t crossed_faces) { return (crossed_faces & (crossed_faces - 1)) == 0; }

/// Whether the paths of a window that is about to cross `face` enter a face for the second time: `face` is their
/// cycle_check_face, or they have crossed as many faces as the mesh has.
///
/// Proof that such a window can be dropped: two points of one face are joined by a straight segment in the face, and
/// nothing in space is shorter. A path that leaves the face between the two points is longer, so from the second point
/// on, the path along the segment beats it.
/// Windows wind round a thin tube as often as it is longer than thick. All these paths are equally long up to rounding,
/// so that comparing lengths does not end them. A path that winds repeats a cycle of faces. A cycle_check_face within
/// the cycle is entered again one cycle later. Such a face is chosen after at most twice the length of the cycle, since
/// the steps are powers of two (Brent's cycle detection). The number of faces bounds all other repetitions.
inline bool enters_face_twice(const WindowHistory& history, FaceId face, std::int32_t face_count) {
  return (face == history.cycle_check_face) | (static_cast<std::int32_t>(history.crossed_faces) >= face_count);
}

/// The shortest path so far that reaches a face's apex straight across the edge on the other side.
struct ApexPath {
  double distance = kInfinity;  ///< length of the path, mesh units
  double crossing = 0;          ///< where it crosses the edge, in the frame of Window
};

/// The sides of a face to which a window continues.
struct Exits {
  bool left = true, right = true;
};

/// One angle, one split: of all windows that cross an edge and cover the apex V, only the window with the shortest path
/// to V needs to continue to both sides. Any other window continues only to the side on which its own path to V
/// arrives. `own` is the window's path to V. `path` is the shortest path of all windows before, and becomes `own` if
/// that is shorter.
///
/// Proof: let S cross the edge at s on its way to V, and W's path to V at w < s, |W V| >= |S V|. Assume that W holds a
/// shortest path to a point R of the right side, which crosses the edge at r. If r <= s, it meets the segment from s to
/// V at a point Q. If not, s lies between the rays of W to V and to R, in a region of the plane that W's rays cover and
/// that contains no vertex. So S, followed backwards, leaves that region through the ray to R, at Q, since two
/// straight lines that meet in V meet nowhere else. Either way |W Q| <= |S Q|, the path through Q being shortest, and
/// |W V| < |W Q| + |Q V| <= |S Q| + |Q V| = |S V|: a contradiction. A tie by rounding happens only if the two paths are
/// the same, and then both sides stay.
/// So at any time at most one window of an edge splits at the apex. Windows that tie everywhere, as on faces without
/// area, do not double with every face.
///
/// Source: Chen and Han (1990), lemma 4.
/// Inputs: crossings within `tolerance` (mesh units) of each other count as the same.
inline Exits exits_beside(ApexPath& path, const ApexPath& own, double tolerance) {
  if (own.distance < path.distance) {
    path = own;
    return {};
  }
  return {!(own.crossing > path.crossing + tolerance), !(own.crossing < path.crossing - tolerance)};
}

}  // namespace gvd
