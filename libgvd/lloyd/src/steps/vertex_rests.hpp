#pragma once

#include <cstddef>
#include <vector>

#include "gvd/mesh.hpp"
#include "integrals/cell_integrals.hpp"
#include "state/generator_moves.hpp"
#include "state/relaxation_state.hpp"

// The energy has kinks at saddle vertices: shortest paths bend there, and the directions of all paths that bend jump as
// the generator passes the vertex. A minimum at such a vertex has no gradient that vanishes. Steps along gradients
// would jump from one side to the other for ever, and the changes of the gradient would mislead a quasi-Newton method.

namespace gvd {

/// A vertex at which a generator can rest.
struct Rest {
  std::size_t generator;
  VertexId vertex;
};

/// The distance at which the energy round a vertex is tried, for generators that may be `move_tolerance` mean cell
/// radii from their centroids; mesh units.
double rest_radius(const RelaxationState& state, double move_tolerance);

/// Marks the generators that rest: they are at a vertex, and no step of the length `radius` lowers the energy of their
/// cell. Their ways to the centroids become zero, and `residual` is that of the others.
void mark_rests(const Mesh& mesh, double radius, CellIntegrals& integrals, RelaxationState& state);

/// The vertices to which generators can go to rest: between a generator and the centroid of its cell, with less energy
/// of the cell than it has now, and less than round the vertex at distance `radius`.
/// Cost: the integrals over some cells, about one for each generator near its centroid.
std::vector<Rest> find_rests(const Mesh& mesh, const RelaxationState& state, double radius, CellIntegrals& integrals);

/// Ends the path of the generator, which began in a face with this vertex, at the vertex. It does not where another
/// generator would be within `gap`. The vertex has no step and turns nothing: no history is kept of resting generators.
void move_to_rest(const Mesh& mesh, const Rest& rest, double gap, const std::vector<SurfacePoint>& from,
                  GeneratorMove& move);

}  // namespace gvd
