#pragma once

#include <vector>

#include "base/barycentric.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// A corner of the part of a face that remains to be assembled: a crossing, or a branch point that replaces two of
/// them.
struct PolygonCorner {
  ArcEnd end;
  Bary bary;
  GeneratorId next;  ///< generator of the label interval from here to the next corner
  int interval;      ///< index of that interval on the face's boundary: it follows the crossing of that index
};

/// A convex polygon in a face, counter-clockwise. Its corners separate the label intervals round it.
using FacePolygon = std::vector<PolygonCorner>;

/// How far a triangle's corner may lie on the wrong side of the opposite edge, in barycentric coordinates, where the
/// distances can confirm branch points. A branch point at a vertex, by a tie, lies kInsideFace from it. That is as
/// near as the crossings round it, and on either side of them. Less than the 1e-11 from which a piece counts as
/// inverted.
inline constexpr double kTieInversion = 4.8e-12;

/// The midpoint of corner i and the next one.
Bary midpoint(const FacePolygon& polygon, std::size_t i);
/// The mean of all corners.
Bary centre(const FacePolygon& polygon);

/// Whether a polygon of three corners or more is convex and counter-clockwise. Every three consecutive corners may be
/// inverted by up to `inversion`, in barycentric coordinates.
bool is_convex(const std::vector<Bary>& polygon, double inversion);

/// Whether p lies in the face and in the polygon, on its boundary, or up to `inversion` outside of it. Crossings of one
/// edge form a polygon without area: then p must lie on that edge, and the pieces between such points have no area, but
/// no negative area either.
bool is_inside(const FacePolygon& polygon, const Bary& p, double inversion);

/// Distance of two points in barycentric coordinates: that of their last two.
double bary_distance(const Bary& p, const Bary& q);

}  // namespace gvd
