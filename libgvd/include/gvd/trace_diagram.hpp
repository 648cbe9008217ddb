#pragma once

#include <functional>
#include <span>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The caller's distance solver: fills in the distances from a generator to all vertices of the mesh, mesh units.
///
/// `row` has one item for each vertex, all infinity. An item is a number from 0 to kLongestDistance, or infinity where
/// the solver does not know the distance. It is called once for each generator, in ascending order, in the caller's
/// thread. What it throws passes through `trace_diagram`.
using DistanceSolver = std::function<void(GeneratorId generator, std::span<double> row)>;

/// The longest finite distance that `trace_diagram` takes: far above every path in a mesh that may be read.
inline constexpr double kLongestDistance = 1e100;

/// Options with the growth tracer: the default of `trace_diagram`.
inline DiagramOptions growth_options() {
  DiagramOptions options;
  options.method = Method::gbgvd;
  return options;
}

/// Builds a complete diagram from distances of any origin: edge paths, heat, an exact solver, measured travel times.
///
/// Section 1 of the paper separates the diagram from the geodesic algorithm; this is that seam. By default the
/// bisectors grow as in sections 4.2 and 4.3, improved; `options.method.tracer` chooses another tracer. The solver of
/// `options.method` is not used. The other options mean what they mean for `compute_diagram`.
///
/// Between vertices distances follow from those at the three corners of each face. At the midpoint of an edge it is the
/// smaller one of those by the front `options.chosen_front()` from the two sides; on each half of the edge it is
/// linear. A circle front comes from the point that two corners' distances determine; a planar front is linear. Where a
/// face has one bisector, both generators are unfolded into the face's plane, and the bisector is where the distances
/// to the two images are equal. So distances must be in mesh units.
///
/// How the numbers are used:
/// - a generator's distance from itself is 0, whatever the row says, and others are farther from it, by a thousandth of
///   the shortest edge there at least: it owns its vertex, and a cell around it;
/// - a generator on an edge or inside a face is a vertex of the working mesh: distances there are linear in the face;
/// - in components of the mesh without the generator the row is ignored;
/// - unknown distances in its component go on from the known ones along the edges, by Dijkstra's algorithm;
/// - ties go to the generator with the lower id: distances grow by at most 1e-9 mean edge lengths to decide them;
/// - no other property is assumed. Every cell is connected; for this, vertices may get another label than that of the
///   nearest generator (`report.relabelled_vertices`). Noise, and distances that break the triangle inequality, cost
///   accuracy and time only.
/// Memory: one row, and for each face the distances of the generators that no other one beats at all three corners;
/// these are 1 to 3 for most faces. Time: O(n) for each row with all distances known, O(n log n) for others.
/// Throws Error{precondition} with the vertex for a distance that is not a number, negative, or beyond kLongestDistance
/// and finite; and as `compute_diagram` does.
Diagram trace_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DistanceSolver& solver,
                      const DiagramOptions& options = growth_options());

/// The same from an array of all distances: those of generator 0 to all vertices, then those of generator 1, and so on.
/// Throws Error{invalid_option} where the array has another size than generators times vertices.
Diagram trace_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, std::span<const double> distances,
                      const DiagramOptions& options = growth_options());

}  // namespace gvd
