#pragma once

#include "geodesic/window.hpp"

namespace gvd {

// Rules that drop windows, or parts of them, that hold no shortest path. Each one is sound for any upper bounds on the
// vertices' distances that real paths have, so that the order in which windows are processed changes no result.

/// A path must be shorter by this part of its length to drop another: far above the rounding of a distance that has
/// been unfolded over a thousand faces (1e-13), so that two equal paths never drop each other.
inline constexpr double kTie = 1e-13;

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

}  // namespace gvd
