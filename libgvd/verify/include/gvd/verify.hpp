#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/error_measure.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

// gvd::verify links CGAL's GPL-licensed Surface_mesh_shortest_path: a program that uses it is under the GPL.

namespace gvd {

struct VerifyOptions {
  int panels = 1;     ///< parts of every bisector segment, see ErrorMeasureOptions; 1 or more
  int threads = 0;    ///< 0 for all cores; the result does not depend on it
  Progress progress;  ///< may be empty
};

/// Exact polyhedral geodesic distances, one independent single-source run a query.
///
/// Source:  Xin and Wang 2009 as CGAL implements it, on doubles with exact predicates. The solver never sees more
/// than the part of the surface within reach: no path of length R from the generator leaves the ball of radius R round
/// it, and the farthest point's distance along edges bounds R. The generator becomes a vertex of that part.
/// Returns: mesh units; infinity where no path leads. In the faces that touch the generator: the straight line.
/// Properties: (1) never below the straight-line distance, but for rounding; (2) never above the distance through a
/// corner of the point's face; (3) the same bytes for any number of threads.
/// Error:   against the reference distances at most 1e-9 relative; faces without area can cost more.
/// Throws Error{precondition} for a point that lies in no face, Error{no_valid_result} where CGAL gives up (element:
/// the query), Error{invalid_option} for threads < 0, Error{interrupted} where the progress callback cancels.
/// Not to be called from two threads at once: CGAL keeps its failure handlers in globals, which are silenced meanwhile.
/// Cost: 100 to 700 times a Dijkstra on the edges of the part within reach; memory freed after each query.
std::vector<std::vector<double>> compute_exact_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries,
                                                         const VerifyOptions& options = {});

/// The error measure E of a diagram against exact distances; see `compute_error_measure`.
ErrorMeasure verify_diagram(const Mesh& mesh, const Diagram& diagram, const VerifyOptions& options = {});

}  // namespace gvd
