#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A generator that is a curve: straight segments between surface points. Distances from it are those from the nearest
/// of all its points. It is one connected piece: a polyline, open or closed, or several that meet.
///
/// Properties of what is computed from curves: (1) the distance is 0 on a curve, and nowhere else; (2) it is never
/// longer than that from any set of points of the curves; (3) a curve lies in its own cell, so that the cell is
/// connected, though it may have holes.
struct GeneratorCurve {
  std::vector<SurfacePoint> points;                        ///< at least one; one alone is a generator as usual
  std::vector<std::array<std::int32_t, 2>> segments = {};  ///< two points each, that have a face in common
};

/// The curve through points in their order; closed from three points on. Cost: O(n).
GeneratorCurve make_polyline(std::vector<SurfacePoint> points, bool closed);

/// Positions along a curve, as polylines: one for a polyline, closed or not, and more where segments branch.
/// Cost: O(n).
std::vector<std::vector<Vec3>> polylines(const Mesh& mesh, const GeneratorCurve& curve);

/// Throws Error{precondition} if there is no curve. The number of the curve is the error's element if a curve has no
/// point or is not connected. So it is if a segment names a point that does not exist, or no face contains both of its
/// points. Cost: O(n).
void check_curves(const Mesh& mesh, const std::vector<GeneratorCurve>& curves);

/// The boundary loops of a mesh, by their first vertices. Cost: O(n).
std::vector<GeneratorCurve> boundary_curves(const Mesh& mesh);

/// The creases of a mesh: connected sets of edges at which the normals of the two faces differ by more than `angle`,
/// degrees, by their first vertices. Throws Error{invalid_option} for an angle that is not in (0, 180]. Cost: O(n).
std::vector<GeneratorCurve> crease_curves(const Mesh& mesh, double angle);

}  // namespace gvd
