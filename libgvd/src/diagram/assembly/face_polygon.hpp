#pragma once

#include <vector>

#include "base/barycentric.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// One corner of what is left of a face to be assembled: a crossing, or a branch point that stands for two of them.
struct PolygonCorner {
  ArcEnd end;
  Bary bary;
  GeneratorId next;  ///< generator of the run from here to the next corner
  int run;           ///< that run: the one of the face's boundary that follows crossing `run`
};

/// A convex polygon in a face, counter-clockwise: its corners part the runs of labels round it.
using FacePolygon = std::vector<PolygonCorner>;

/// How much of every barycentric coordinate a branch point keeps that lies by a tie on a side or at a vertex, where the
/// metric is as good as exact: it is not moved by more than rounding. A little below what such a metric puts its points
/// inside by, so that these are taken as they are.
inline constexpr double kInsideExactly = 1.2e-12;

/// How far beyond its opposite side a triangle's corner may lie, in barycentric coordinates. A branch point at a
/// vertex, by a tie, lies kInsideFace from it, as near as the crossings round it, and on whichever side of them; below
/// the 1e-11 from which a piece counts as turned.
inline constexpr double kTurnedByTie = 4.8e-12;

/// The middle between corner i and the next one, and that of all corners.
Bary middle(const FacePolygon& polygon, std::size_t i);
Bary centre(const FacePolygon& polygon);

/// Whether a polygon, of three corners or more, is convex; every three corners that follow each other may be turned the
/// wrong way round by up to `beyond`.
bool is_convex(const std::vector<Bary>& polygon, double beyond);

/// In the face and in the polygon, or on its boundary, or up to `beyond` outside of it. Crossings of one edge span a
/// polygon without area: then branch points lie on that edge, and the pieces between them have no area either, but
/// never a negative one.
bool is_inside(const FacePolygon& polygon, const Bary& p, double beyond);

/// Distance in barycentric coordinates.
double apart(const Bary& p, const Bary& q);

}  // namespace gvd
