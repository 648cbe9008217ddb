#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A generator that is a curve: straight segments between surface points. The distance from it is the distance from the
/// nearest of its points. A curve is connected: it is a polyline, open or closed, or several polylines that meet.
///
/// Properties of what is computed from curves: (1) the distance is 0 on a curve, and nowhere else; (2) it is never
/// longer than the distance from any set of points of the curves; (3) a curve lies in its own cell, so that the cell is
/// connected, though it may have holes.
struct GeneratorCurve {
  std::vector<SurfacePoint> points;                        ///< at least one; a single point is an ordinary generator
  std::vector<std::array<std::int32_t, 2>> segments = {};  ///< indices of two points each, which have a face in common
};

/// Makes the curve through points in their order. If `closed` and there are three points or more, the last one is
/// joined to the first. Cost: O(n).
GeneratorCurve make_polyline(std::vector<SurfacePoint> points, bool closed);

/// The positions along a curve, in mesh units, as polylines: one if the segments follow each other, and more if they
/// branch.
/// Cost: O(n).
std::vector<std::vector<Vec3>> polylines(const Mesh& mesh, const GeneratorCurve& curve);

/// Throws Error{precondition} if there is no curve, or if a curve has no point, is not connected, or has a segment
/// whose points don't exist or have no face in common. In these cases `element` of the error is the number of the
/// curve. Cost: O(n).
void check_curves(const Mesh& mesh, const std::vector<GeneratorCurve>& curves);

/// The boundary loops of a mesh as curves, in the order of their first vertices. Cost: O(n).
std::vector<GeneratorCurve> boundary_curves(const Mesh& mesh);

/// The creases of a mesh as curves, in the order of their first vertices: connected sets of edges at which the normals
/// of the two faces differ by more than `angle`, in degrees. Throws Error{invalid_option} for an angle that is not in
/// (0, 180]. Cost: O(n).
std::vector<GeneratorCurve> crease_curves(const Mesh& mesh, double angle);

}  // namespace gvd
