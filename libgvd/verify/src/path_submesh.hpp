#pragma once

#include <array>
#include <vector>

#include "gvd/error_measure.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A submesh that contains the shortest paths from a generator to the points of a query, with the generator as a
/// vertex.
struct PathSubmesh {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;  ///< oriented, manifold, in the mesh's order; they use all vertices
  VertexId source;                             ///< the generator's vertex; invalid if there is no target
  /// A point whose distance needs the solver.
  struct Target {
    std::size_t point;  ///< index into the query's points
    FaceId face;        ///< a face of the submesh
    std::array<double, 3> bary;
  };
  std::vector<Target> targets;
  /// The distance of each point of the query that needs no solver: Euclidean in the faces that contain the generator,
  /// infinity without a path. NaN for the targets.
  std::vector<double> distances;
};

/// Extracts the submesh for a query. Let R be the largest distance of a target along edges, an upper bound of the exact
/// distance. A path of length R stays in the ball of radius R around the generator. The faces that it visits are
/// connected across edges, because all faces around a vertex on the path intersect the ball. So the submesh consists of
/// the faces that intersect the ball and are connected to the generator's faces through such faces. A vertex at which
/// several fans of these faces remain is duplicated; no shortest path passes through it.
/// Throws Error{precondition} if a point or the generator lies in no face. Cost: O(n log n).
PathSubmesh extract_path_submesh(const Mesh& mesh, const DistanceQuery& query);

}  // namespace gvd
