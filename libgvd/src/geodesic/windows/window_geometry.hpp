#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/window.hpp"

namespace gvd {

// How a window's paths run through the face that they enter. These are pure functions of the face's lengths and angles.

/// One side of a face, seen from a window that enters through another side.
///
/// `near` is the corner that the side shares with the window's edge. Let u be the distance from `near` along the
/// window's edge. The image is at (u_image, -depth). Cosine and sine are those of the angle at `near`. Then the ray
/// through u intersects the side at distance u depth / (depth cos + (u_image - u) sin) from `near`. This takes one
/// division, and loses no digits unless the ray runs along the side.
struct SideView {
  double cosine, sine;  ///< the cosine and sine of the angle at `near`
  double along;         ///< position of the image's foot on the side, from `near`
  double depth;         ///< distance of the image behind the side
  double image, below;  ///< u_image and depth on the window's edge

  SideView(double cos_near, double sin_near, double u_image, double image_depth)
      : cosine(cos_near),
        sine(sin_near),
        along(u_image * cos_near - image_depth * sin_near),
        depth(u_image * sin_near + image_depth * cos_near),
        image(u_image),
        below(image_depth) {}

  /// Distance from `near` at which the ray through u intersects the side.
  double hit(double u) const { return u * below / (below * cosine + (image - u) * sine); }
};

/// Position of the apex, the corner of the face opposite to a window's edge, relative to the window's outermost rays.
struct ApexView {
  double x, y;          ///< the apex in the window's frame
  double beyond_begin;  ///< > 0: the ray through `begin` passes to the right of the apex, which stays outside
  double beyond_end;    ///< < 0: the ray through `end` passes to the left of the apex, which stays outside

  ApexView(const Window& w, double apex_x, double apex_y)
      : x(apex_x),
        y(apex_y),
        beyond_begin((w.begin - w.x) * apex_y - (apex_x - w.begin) * w.depth),
        beyond_end((w.end - w.x) * apex_y - (apex_x - w.end) * w.depth) {}

  bool all_right() const { return beyond_begin > 0; }
  bool all_left() const { return beyond_end < 0; }
  bool covered() const { return beyond_begin <= 0 && beyond_end >= 0; }
  /// Square of the distance from the window's image to the apex.
  double squared_image_distance(const Window& w) const { return (x - w.x) * (x - w.x) + (y + w.depth) * (y + w.depth); }
};

/// A path that bends by less than this angle, in radians, at the end of a window's interval counts as straight.
/// Otherwise rounding, which comes to 1e-12, would let a vertex fall between the windows on its two sides. A path that
/// is accepted wrongly is too short by half the square of the angle: 5e-19 of its last straight piece.
inline constexpr double kGrazingAngle = 1e-9;

/// Whether the apex, which is not covered, lies on the continuation of the window's outermost ray: within kGrazingAngle
/// of it, or within the rounding of the interval's end on an edge of this length. The path to the apex is then too
/// short by no more than that. The path must go forwards, because in a face without area a path that turns back has a
/// sine of 0, too.
inline bool is_grazed(const Window& w, const ApexView& apex, double length) {
  const double t = apex.all_right() ? w.begin : w.end;
  const double beyond = apex.all_right() ? apex.beyond_begin : apex.beyond_end;
  const double squared_step = (apex.x - t) * (apex.x - t) + apex.y * apex.y;
  const double forwards = (t - w.x) * (apex.x - t) + w.depth * apex.y;
  // The change of `beyond` when the end moves by kPositionRounding.
  const double shift = kPositionRounding * length * (w.depth + apex.y);
  const double bend = kGrazingAngle * kGrazingAngle * w.squared_image_distance(t) * squared_step;
  return beyond * beyond <= bend + shift * shift && forwards > 0;
}

/// Whether the apex is so far beside the window that it can't be grazed. This holds for most windows, and is cheaper to
/// test. `longest` is the square of the longest side of the face.
///
/// Proof: let q be the squared distance of the image from the interval's end. The squares of the two limits in
/// is_grazed add up to at most longest times kGrazingAngle^2 q + kPositionRounding^2 (depth + y)^2. Moreover,
/// (depth + y)^2 <= 2 q + 2 longest.
inline bool is_far_beside(const Window& w, const ApexView& apex, double longest) {
  const double t = apex.all_right() ? w.begin : w.end;
  const double beyond = apex.all_right() ? apex.beyond_begin : apex.beyond_end;
  return beyond * beyond > 2 * kGrazingAngle * kGrazingAngle * longest * (w.squared_image_distance(t) + longest);
}

/// Whether the window misses the apex, which is not covered, by no more than the angle `drift` at its image. The path
/// over the end of the interval must be as long as the straight one, up to rounding.
///
/// Thin faces open a gap between two windows that pass a vertex on both sides: the rounding of a long side, seen over a
/// short side, is an angle of kPositionRounding divided by the least sine. The gap widens along the paths. An apex in
/// it that is a short side away from the window asks for a bend of far more than kGrazingAngle. The path is no longer,
/// though: with the miss m, the distance r to the interval's end and the step s from there, by m^2 / 2 (1 / r + 1 / s).
inline bool is_in_gap(const Window& w, const ApexView& apex, double drift) {
  const double t = apex.all_right() ? w.begin : w.end;
  const double beyond = apex.all_right() ? apex.beyond_begin : apex.beyond_end;
  const double squared_to_end = w.squared_image_distance(t);
  const double squared_step = (apex.x - t) * (apex.x - t) + apex.y * apex.y;
  const double squared_miss = beyond * beyond / squared_to_end;
  if (!(squared_miss <= drift * drift * squared_to_end)) return false;
  const double forwards = (t - w.x) * (apex.x - t) + w.depth * apex.y;
  return squared_miss <= 2 * kPositionRounding * std::sqrt(squared_to_end * squared_step) && forwards > 0;
}

/// A side by which windows leave a face, as seen from the corner that it shares with the edge by which they enter.
struct ExitSide {
  double cosine, sine;  ///< the cosine and sine of the angle at that corner
  double length;
  HalfedgeId twin;
};

/// The left side of a face that windows enter by edge i, from the edge's start to the apex.
inline ExitSide left_exit(const FaceFrame& f, std::size_t i) {
  const std::size_t side = (i + 2) % 3;
  return {f.cosine[i], f.sine[i], f.length[side], f.twin[side]};
}
/// The right side, from the apex to the edge's end.
inline ExitSide right_exit(const FaceFrame& f, std::size_t i) {
  const std::size_t side = (i + 1) % 3;
  return {f.cosine[side], f.sine[side], f.length[side], f.twin[side]};
}

/// The sub-window of a window that leaves the face by the left side.
[[gnu::always_inline]] inline Window cross_left(const Window& w, const ExitSide& side, const ApexView& apex) {
  const SideView view(side.cosine, side.sine, w.x, w.depth);
  const double end = apex.all_left() ? std::min(side.length, view.hit(w.end)) : side.length;
  return {std::max(0.0, view.hit(w.begin)), end, view.along, view.depth, w.offset, w.generator, side.twin};
}

/// The sub-window that leaves the face by the right side. `base`: length of the edge by which the window enters.
[[gnu::always_inline]] inline Window cross_right(const Window& w, double base, const ExitSide& side,
                                                 const ApexView& apex) {
  const SideView view(side.cosine, side.sine, base - w.x, w.depth);
  const double length = side.length;
  const double begin = apex.all_right() ? std::max(0.0, length - view.hit(base - w.begin)) : 0;
  const double end = std::min(length, length - view.hit(base - w.end));
  return {begin, end, length - view.along, view.depth, w.offset, w.generator, side.twin};
}

}  // namespace gvd
