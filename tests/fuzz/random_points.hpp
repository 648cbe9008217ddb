#pragma once

#include <string>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "support/random.hpp"

namespace gvd::test {

struct RandomPoints {
  std::string name;  ///< of how they were chosen, for messages
  std::vector<SurfacePoint> points;
};

/// Generators of every kind: on vertices, on edges, in faces, on the boundary, all in one face, in a row along one
/// edge, round one vertex, in clusters that nearly coincide, and now and then two that do.
RandomPoints make_random_points(const Mesh& mesh, Random& random);

/// Whether two of them are nearer to each other than `close`, as a part of the mean edge, or one to a vertex or an edge
/// that it is not on, as a part of a triangle's height: then triangles of the working mesh are thin.
bool are_close(const Mesh& mesh, const std::vector<SurfacePoint>& points, double close);

/// Closer than this, a point's coordinates in the thin triangles between generators are rounded by more than distances
/// are compared to, and runs on edges are shorter than the shortest one that is kept, which cuts cells off.
inline constexpr double kClose = 1e-5;

/// Closer than this, branch points between generators come as near to each other as cutting welds.
inline constexpr double kWelded = 1e-9;

}  // namespace gvd::test
