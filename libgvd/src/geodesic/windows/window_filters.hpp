#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "geodesic/windows/window.hpp"

namespace gvd {

// Rules that drop windows, or parts of them, that hold no shortest path. Each one is sound for any upper bounds on the
// vertices' distances that real paths have, so that the order in which windows are processed changes no result.

/// A path must be shorter by this part of its length to drop another: far above the rounding of a distance that has
/// been unfolded over a thousand faces (1e-13), so that two equal paths never drop each other.
inline constexpr double kTie = 1e-13;

/// A distance must fall by this part of itself to be news. Two paths of the same length differ by rounding, a few
/// units in the last place; what the second one led to would repeat what the first one did.
inline constexpr double kLengthRounding = 4e-15;

/// Whether a path of length `d` is news where one of length `known` is known.
inline bool is_shorter_beyond_rounding(double d, double known) { return d < known * (1 - kLengthRounding); }

/// Paths whose lengths differ by less than this part of themselves are equally long: more than what two equal paths
/// differ by that come from different generators, through other faces each. Below half of kTie, so that no window is
/// dropped before it has brought a path that is equally long.
inline constexpr double kSameLength = 2e-14;

/// The order of paths to one vertex, which decides ties: (length, generator), lengths that differ by less than
/// kSameLength being equal. Whether a path of length `d` from `generator` comes before the known one, which comes from
/// `label`; of one generator's paths, only what is news does.
///
/// Where paths from several generators tie, as on symmetric meshes, the one that rounding or the order in which windows
/// are taken happens to prefer must not win: the labels of neighbouring vertices would not agree on it.
inline bool is_before(double d, std::int32_t generator, double known, std::int32_t label) {
  if (!(d * (1 - kSameLength) < known)) return false;  // most of them
  if (d < known * (1 - kSameLength)) return true;
  return is_shorter_beyond_rounding(d, known) ? generator <= label : generator < label;
}

/// Whether a window has no width, or its rays run along the edge.
inline bool is_empty(const Rays& w) { return !(w.begin < w.end) | !(w.depth > 0); }

/// Whether a path of length `through` + `step` is shorter than one of `offset` + sqrt(squared), and not by rounding.
/// No square root: the bounds are compared as (through + step - offset)^2 < squared.
inline bool is_shorter(double through, double step, double offset, double squared) {
  const double rest = through * (1 + kTie) + step - offset;
  return rest * std::abs(rest) < squared * (1 - kTie);  // true for a negative rest
}

/// Whether the path through the start of the edge is shorter all over the window.
///
/// Proof: let it be shorter at the interval's end B: d + |vB| < s + |IB|, v being the edge's start. For a point P of
/// the interval, |vP| = |vB| - |PB| (P lies between v and B on one line) and |IP| >= |IB| - |PB|, so d + |vP| < s +
/// |IB| - |PB| <= s + |IP|.
inline bool is_beaten_by_start(const Rays& w, double offset, double start_distance) {
  return is_shorter(start_distance, w.end, offset, w.squared_reach(w.end));
}

/// The same from the end of the edge, which is `length` long.
inline bool is_beaten_by_end(const Rays& w, double offset, double end_distance, double length) {
  return is_shorter(end_distance, length - w.begin, offset, w.squared_reach(w.begin));
}

/// Whether the path through an end of the edge, at `end_distance` from the generator and `step` from the far end of the
/// interval, is no news to the window: shorter or longer by rounding. Where that end is a ambiguous vertex, which sends
/// windows in all directions itself, the window can be left to it.
///
/// Proof: as for is_beaten_by_start, the path through the vertex is at most kLengthRounding longer at all points of the
/// interval, and so it is at all points behind, whatever way the window's paths go on; the vertex' own windows hold one
/// that is no longer. They start nearer to these points, so that leaving a window to a vertex never goes in a circle.
/// Without it, where needles make a thin tube, as many windows as it has vertices are carried along from each of them.
inline bool is_left_to_vertex(double offset, double end_distance, double step, double squared) {
  const double rest = (end_distance + step) * (1 - kLengthRounding) - offset;
  return rest * std::abs(rest) < squared;
}

/// Whether a window that has crossed this many faces takes the last one of them for its cycle_check_face: a power of
/// two.
inline bool is_cycle_check_step(std::int32_t crossed) { return (crossed & (crossed - 1)) == 0; }

/// Whether the paths of a window that is about to cross `face` meet a face for the second time: it is their
/// cycle_check_face, or they have crossed as many faces as there are.
///
/// Proof: two points of one face are joined by a straight segment in it, and nothing in space is shorter. A path that
/// leaves the face in between is longer; from the first point on, the segment beats it.
/// Windows wind round a thin tube as often as it is longer than thick, and all these paths have one length but for
/// rounding, so that no comparison of lengths ends it. A path that winds repeats a cycle of faces: a cycle_check_face
/// within the cycle is met again one cycle later, and the last power of two comes no later than twice the length of the
/// cycle (Brent's way to find cycles). The number of faces bounds what repeats itself in any other way.
inline bool is_crossed_twice(const Origin& origin, std::int32_t face, std::int32_t faces) {
  return (face == origin.cycle_check_face) | (origin.crossed >= faces);
}

/// The shortest path so far that reaches a face's apex straight across the edge on the other side.
struct ApexPath {
  double distance = std::numeric_limits<double>::infinity();  ///< of the apex on it, mesh units
  double crossing = 0;                                        ///< where it crosses the edge, in the frame of Rays
};

/// The sides of a face that a window goes on to.
struct Exits {
  bool left = true, right = true;
};

/// One angle, one split: of all windows that cross an edge and cover the apex, only the one whose path to the apex V is
/// the shortest needs to go on to both sides of it. Another one goes on to the side only on which its own path to V
/// arrives. Makes `path` the best path so far, `own` and all that came before.
///
/// Proof: let S cross the edge at s on its way to V, and W's path to V at w < s, |W V| >= |S V|. Assume that W holds a
/// shortest path to a point R of the right side, which crosses the edge at r. If r <= s, it meets the segment from s to
/// V at a point Q. If not, s lies between the rays of W to V and to R, in a part of the plane that W's rays cover and
/// that no vertex lies in; so S, followed backwards, leaves that part, and through the ray to R, at Q, since two
/// straight lines that meet in V meet nowhere else. Either way |W Q| <= |S Q|, the path through Q being shortest, and
/// |W V| < |W Q| + |Q V| <= |S Q| + |Q V| = |S V|: a contradiction. A tie is one by rounding only where the two paths
/// are one, and that is left alone.
/// With it an edge has at most one window that splits at any time, and windows that tie all over, as on faces without
/// area, don't double with every face.
///
/// Source: Chen and Han (1990), lemma 4.
/// Inputs: `tolerance`, within which crossings are one, mesh units.
inline Exits exits_beside(ApexPath& path, const ApexPath& own, double tolerance) {
  if (own.distance < path.distance) {
    path = own;
    return {};
  }
  return {!(own.crossing > path.crossing + tolerance), !(own.crossing < path.crossing - tolerance)};
}

}  // namespace gvd
