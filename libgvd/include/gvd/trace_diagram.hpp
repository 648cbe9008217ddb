#pragma once

#include <functional>
#include <span>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The caller's distance solver: fills in the distances from a generator to all vertices of the mesh, in mesh units.
///
/// `row` has one item per vertex, and all items are infinity at first. The solver sets them to numbers from 0 to
/// kLongestDistance, or leaves them infinite if it doesn't know the distance. It is called once for each generator, in
/// ascending order, in the caller's thread. `trace_diagram` passes on its exceptions.
using DistanceSolver = std::function<void(GeneratorId generator, std::span<double> row)>;

/// The longest finite distance that `trace_diagram` accepts. It is far above the length of every path in a mesh that
/// can be read.
inline constexpr double kLongestDistance = 1e100;

/// Options with the growth tracer, which `trace_diagram` uses by default.
inline DiagramOptions growth_options() {
  DiagramOptions options;
  options.method = Method::gbgvd;
  return options;
}

/// Builds a complete diagram from distances of any origin: edge paths, the heat method, an exact solver, measured
/// travel times.
///
/// Section 1 of the paper separates the diagram from the geodesic algorithm; this is that seam. By default the
/// bisectors grow as in sections 4.2 and 4.3, improved; `options.method.tracer` chooses another tracer. The solver of
/// `options.method` is not used. The other options mean what they mean for `compute_diagram`.
///
/// Between vertices, distances are derived from those at the three corners of each face. At the midpoint of an edge,
/// the front `options.chosen_front()` gives a distance from either side, and the smaller one counts; on each half of
/// the edge the distance is linear. A circle front comes from the point that the distances of two corners determine; a
/// planar front is linear. In a face with one bisector, both generators are unfolded into the face's plane, and the
/// bisector is the line of equal distances from the two images. Distances must therefore be in mesh units.
///
/// How the numbers are used:
/// - a generator's distance from itself is 0, whatever the row says, and every other generator is farther from it by at
///   least a thousandth of the shortest edge there, so that a generator's vertex and some surface around it belong to
///   its cell;
/// - a generator on an edge or inside a face becomes a vertex of the working mesh, at which distances are interpolated
///   linearly in the face;
/// - in components of the mesh that don't contain the generator, its row is ignored;
/// - unknown distances in its component are filled in along the edges from the known ones, by Dijkstra's algorithm;
/// - ties go to the generator with the lower id: distances grow by at most 1e-9 mean edge lengths to decide them;
/// - no other property is assumed. Every cell is connected; to achieve this, vertices may get the label of another
///   generator than the nearest (`report.relabelled_vertices`). Noise, and distances that break the triangle
///   inequality, only cost accuracy and time.
/// Properties: (1) `check_diagram` finds no violation, unless `report.unresolved_ends` is above 0; (2) the result is
/// bit-identical for any number of threads.
/// Memory: one row, and for each face the distances of the generators that no other generator beats at all three
/// corners; in most faces these are 1 to 3. Time: O(n) for each row with all distances known, O(n log n) for others.
/// Throws Error{precondition} with the vertex for a distance that is not a number, negative, or finite and above
/// kLongestDistance; also throws what `compute_diagram` throws.
Diagram trace_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DistanceSolver& solver,
                      const DiagramOptions& options = growth_options());

/// The same from an array of all distances: those from generator 0 to all vertices, then those from generator 1, and so
/// on. Throws Error{invalid_option} if the size of the array is not generators times vertices.
Diagram trace_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, std::span<const double> distances,
                      const DiagramOptions& options = growth_options());

}  // namespace gvd
