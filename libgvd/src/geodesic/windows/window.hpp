#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geodesic/windows/face_frames.hpp"

namespace gvd {

/// Images that differ by less than this part of their distance are one, and so are the rays from them through one
/// point: a thousand times the rounding of a distance, as it comes out of unfolding a thousand faces.
inline constexpr double kSameImage = 3e-13;

/// All shortest paths that reach one interval of an edge from one side through the same faces: they come straight from
/// one image of a generator, or of a pseudo-source, in the plane of the face that they leave.
///
/// Source: Mitchell, Mount and Papadimitriou (1987); Chen and Han (1990).
/// Frame: the edge lies on the x axis and the paths come from below. Its origin is the start of the halfedge that they
/// cross next, in the face beyond, x towards that halfedge's end; on the boundary, where there is no such halfedge, the
/// end of the halfedge of the face that they leave, x towards its start. Mesh units.
struct Rays {
  double begin, end;  ///< interval on the edge, 0 <= begin < end <= length
  double x, depth;    ///< the image lies at (x, -depth), depth > 0

  /// Square of the distance from the image to the point t of the edge.
  double squared_reach(double t) const { return (t - x) * (t - x) + depth * depth; }
  double reach(double t) const { return std::sqrt(squared_reach(t)); }
  /// The least distance from the image to the interval.
  double least_reach() const { return reach(std::min(std::max(x, begin), end)); }
};

/// Where the paths of a window come from, and whether its two ends may be joined to other windows' without a step.
struct Origin {
  double offset;                  ///< distance from the generator to the image's vertex, mesh units
  std::int32_t generator;         ///< GeneratorId
  std::int32_t crossed;           ///< number of faces that the paths have crossed
  std::int32_t cycle_check_face;  ///< one of these faces (is_cycle_check_step in window_filters.hpp), or -1
  std::uint8_t joins;             ///< bit 0: at `begin`; bit 1: at `end`

  static constexpr std::uint8_t kAtBegin = 1, kAtEnd = 2;
};

/// One side of a face, seen from a window that enters through another: what the window's rays meet there.
///
/// `near` is the corner that the side shares with the window's edge. With u the distance from `near` along the window's
/// edge, the image at (u_image, -depth), and the angle at `near` between the two sides, the ray through u meets the
/// side at distance u depth / (depth cos + (u_image - u) sin) from `near`: one division, and no cancellation but where
/// the ray runs along the side.
struct SideView {
  double cosine, sine;  ///< of the angle at `near`
  double along;         ///< of the image's foot on the side, from `near`
  double depth;         ///< of the image behind the side
  double image, below;  ///< u_image and depth on the window's edge

  SideView(double cos_near, double sin_near, double u_image, double image_depth)
      : cosine(cos_near),
        sine(sin_near),
        along(u_image * cos_near - image_depth * sin_near),
        depth(u_image * sin_near + image_depth * cos_near),
        image(u_image),
        below(image_depth) {}

  double hit(double u) const { return u * below / (below * cosine + (image - u) * sine); }
};

/// Where the apex, the corner of the face opposite to a window's edge, lies between the window's rays.
struct ApexView {
  double x, y;          ///< the apex in the window's frame
  double beyond_begin;  ///< > 0: the ray through `begin` passes to the right of the apex, which stays outside
  double beyond_end;    ///< < 0: the ray through `end` passes to the left of the apex, which stays outside

  ApexView(const Rays& w, double apex_x, double apex_y)
      : x(apex_x),
        y(apex_y),
        beyond_begin((w.begin - w.x) * apex_y - (apex_x - w.begin) * w.depth),
        beyond_end((w.end - w.x) * apex_y - (apex_x - w.end) * w.depth) {}

  bool all_right() const { return beyond_begin > 0; }
  bool all_left() const { return beyond_end < 0; }
  bool covered() const { return beyond_begin <= 0 && beyond_end >= 0; }
  double squared_reach(const Rays& w) const { return (x - w.x) * (x - w.x) + (y + w.depth) * (y + w.depth); }
};

/// A path that bends by less than this, in radians, at the end of a window's interval is taken for straight: rays that
/// graze a vertex would otherwise miss the windows on both sides of it by rounding, which comes to 1e-12. What is
/// accepted wrongly is too short by half the square of it: 5e-19 of the last piece of the path.
inline constexpr double kGrazingAngle = 1e-9;

/// Whether the apex, not covered, lies on the continuation of the window's outermost ray within kGrazingAngle, or
/// within what rounding moves the end of the interval by on an edge of this length: then the path is too short by no
/// more than that. A path that turns back at the end of the interval, as it would into a face without area, has no sine
/// either: it has to go on forwards.
inline bool is_grazed(const Rays& w, const ApexView& apex, double length) {
  const double t = apex.all_right() ? w.begin : w.end;
  const double beyond = apex.all_right() ? apex.beyond_begin : apex.beyond_end;
  const double squared_step = (apex.x - t) * (apex.x - t) + apex.y * apex.y;
  const double forwards = (t - w.x) * (apex.x - t) + w.depth * apex.y;
  const double shift = kRounding * length * (w.depth + apex.y);  // what moving the end by kRounding does to `beyond`
  const double bend = kGrazingAngle * kGrazingAngle * w.squared_reach(t) * squared_step;
  return beyond * beyond <= bend + shift * shift && forwards > 0;
}

/// Whether the apex, not covered, is missed by no more than `drift`, an angle at the image, and the way to it over the
/// end of the interval is as long as the straight one but for rounding.
///
/// Between two windows that pass a vertex on both sides, thin faces open a gap: the rounding of a long side, seen over
/// a short one, is an angle of kRounding over the least sine. The gap grows with the way; where an apex lies in it that
/// is a short side away from the window, the path bends by far more than kGrazingAngle, and yet is no longer: with the
/// miss m, the reach r and the step s, by m^2 / 2 (1 / r + 1 / s).
inline bool is_in_gap(const Rays& w, const ApexView& apex, double drift) {
  const double t = apex.all_right() ? w.begin : w.end;
  const double beyond = apex.all_right() ? apex.beyond_begin : apex.beyond_end;
  const double squared_reach = w.squared_reach(t), squared_step = (apex.x - t) * (apex.x - t) + apex.y * apex.y;
  const double squared_miss = beyond * beyond / squared_reach;
  if (!(squared_miss <= drift * drift * squared_reach)) return false;
  const double forwards = (t - w.x) * (apex.x - t) + w.depth * apex.y;
  return squared_miss <= 2 * kRounding * std::sqrt(squared_reach * squared_step) && forwards > 0;
}

/// The part of a window that leaves the face by the left side, from the edge's start to the apex.
inline Rays cross_left(const Rays& w, const FaceFrame& f, std::size_t i, const ApexView& apex) {
  const SideView view(f.cosine[i], f.sine[i], w.x, w.depth);
  const double length = f.length[(i + 2) % 3];
  const double end = apex.all_left() ? std::min(length, view.hit(w.end)) : length;
  return {std::max(0.0, view.hit(w.begin)), end, view.along, view.depth};
}

/// The part of a window that leaves the face by the right side, from the apex to the edge's end.
inline Rays cross_right(const Rays& w, const FaceFrame& f, std::size_t i, const ApexView& apex) {
  const std::size_t side = (i + 1) % 3;
  const double base = f.length[i], length = f.length[side];
  const SideView view(f.cosine[side], f.sine[side], base - w.x, w.depth);
  const double begin = apex.all_right() ? std::max(0.0, length - view.hit(base - w.begin)) : 0;
  return {begin, std::min(length, length - view.hit(base - w.end)), length - view.along, view.depth};
}

}  // namespace gvd
