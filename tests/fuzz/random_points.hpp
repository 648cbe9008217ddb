#pragma once

#include <string>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "support/random.hpp"

namespace gvd::test {

struct RandomPoints {
  std::string name;  ///< how they were chosen, for messages
  std::vector<SurfacePoint> points;
};

/// Generators of every kind: on vertices, on edges, in faces, on the boundary. They may all lie in one face, in a row
/// along one edge, round one vertex, or in clusters that nearly coincide; sometimes two do coincide.
RandomPoints make_random_points(const Mesh& mesh, Random& random);

/// Whether the working mesh has thin triangles: two points are closer than the fraction `close` of the mean edge
/// length. Or a point is closer than that fraction of a triangle's height to a vertex or edge that it is not on.
bool are_close(const Mesh& mesh, const std::vector<SurfacePoint>& points, double close);

/// For closer generators, rounding of coordinates in the thin triangles between them exceeds the error allowed in the
/// comparison of distances. Label intervals on edges are then shorter than the shortest one that is kept, so that cells
/// can be cut off.
inline constexpr double kClose = 1e-5;

/// For closer generators, branch points between them are so close that cutting welds them.
inline constexpr double kWelded = 1e-9;

}  // namespace gvd::test
