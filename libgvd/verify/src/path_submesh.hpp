#pragma once

#include <array>
#include <vector>

#include "gvd/error_measure.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The part of a mesh that the shortest paths from a generator to its points can visit, with the generator as a vertex.
struct Reach {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;  ///< oriented and manifold; indices into positions
  int source = -1;                        ///< the generator's vertex; -1 where there is nothing to solve
  /// Points to solve for, as indices into the query's list, with the local face and the coordinates in it.
  struct Target {
    std::size_t point;
    int face;
    std::array<double, 3> bary;
  };
  std::vector<Target> targets;
  /// The distance of every point of the query, filled in where no solver is needed: the straight line in the faces
  /// that touch the generator, infinity where no path leads. Not a number at the targets.
  std::vector<double> distances;
};

/// Cuts out what lies within reach: every face that a path no longer than the farthest target's distance along the
/// edges can visit. A path of that length stays in the ball of that radius round the generator, and the faces that
/// it visits are linked across edges: at a vertex that it passes, all faces are in the ball.
/// Vertices at which the cut leaves several fans are doubled; no shortest path passes them.
/// Throws Error{precondition} where a point or the generator lies in no face. Cost: O(n log n).
Reach cut_reach(const Mesh& mesh, const DistanceQuery& query);

}  // namespace gvd
