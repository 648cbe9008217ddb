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

/// Whether two points are closer in space than the fraction `close` of the bounding box's diagonal, or than 0.01 of
/// that fraction of the largest coordinate.
bool are_close(const Mesh& mesh, const std::vector<SurfacePoint>& points, double close);

// What is known to fail between close generators, with the scale at which it begins: docs/developer/exact.md, "Close
// generators". Fractions as `are_close` takes them.

/// For closer generators, label intervals on edges can be shorter than the shortest one that is kept. Rounding of
/// positions turns triangles between them by a hundredth. So cells are cut off, and vertices get other labels.
/// Distances of vertices are right nevertheless.
inline constexpr double kClose = 1e-11;

/// For closer generators, cutting may find no manifold mesh, as branch points between them are welded.
inline constexpr double kWelded = 1e-10;

}  // namespace gvd::test
