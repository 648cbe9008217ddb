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

/// Whether two of them are very near to each other, or one to a vertex or an edge that it is not on: then triangles of
/// the working mesh are thin.
bool are_close(const Mesh& mesh, const std::vector<SurfacePoint>& points);

/// What is close, as a part of the mean edge or of a triangle's height; and what is thin, as a part of the square of
/// the longest edge. Any numbers that part the ordinary from the extreme.
inline constexpr double kClose = 1e-3, kThin = 1e-3;

/// Whether a face is a needle or has no area.
bool has_thin_faces(const Mesh& mesh);

}  // namespace gvd::test
