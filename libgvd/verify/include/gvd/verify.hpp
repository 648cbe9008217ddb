#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/error_measure.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

// gvd::verify links CGAL's Surface_mesh_shortest_path, which is licensed under the GPL. So a program that uses it falls
// under the GPL, too.

namespace gvd {

struct VerifyOptions {
  int panels = 1;     ///< panels for each bisector segment (see ErrorMeasureOptions); >= 1
  int threads = 0;    ///< >= 0; 0: as many as there are cores. The result does not depend on it
  Progress progress;  ///< may be empty
};

/// Computes exact polyhedral geodesic distances, by an independent single-source computation for each query. Results
/// are indexed by query and by point of the query.
///
/// Source:  Xin and Wang 2009 as CGAL implements it, on doubles with exact predicates. The solver works on a submesh
///   only: a path of length R stays in the ball of radius R around the generator. The largest distance of a point along
///   edges bounds R. The generator becomes a vertex of the submesh. If CGAL's distance is longer than a path on the
///   surface, which the library's own solver proposes, the length of that path is returned, measured along its points.
/// Returns: mesh units; infinity without a path. Euclidean in the faces that contain the generator.
/// Properties: (1) at least the Euclidean distance, within rounding; (2) at most the distance through a corner of the
///   point's face; (3) the same bytes for any number of threads.
/// Error:   at most 1e-9 relative against the reference distances; more where faces have no area, and on needles where
///   CGAL loses a window by rounding and the solver proposes no shorter path. No distance is too short.
/// Throws Error{precondition} for a point that lies in no face, Error{no_valid_result} if CGAL fails (element: the
/// query), Error{invalid_option} for threads < 0, Error{interrupted} if the progress callback cancels.
/// Must not be called from two threads at once, because CGAL's failure handlers are global and are replaced during the
/// call.
/// Cost: 100 to 700 times Dijkstra's algorithm on the edges of the submesh; memory is freed after each query.
std::vector<std::vector<double>> compute_exact_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries,
                                                         const VerifyOptions& options = {});

/// Measures the error E of a diagram against exact distances (see `compute_error_measure`), and counts the distances of
/// CGAL that were corrected. Throws what `compute_exact_distances` throws. Cost: one query for each generator.
ErrorMeasure verify_diagram(const Mesh& mesh, const Diagram& diagram, const VerifyOptions& options = {});

}  // namespace gvd
