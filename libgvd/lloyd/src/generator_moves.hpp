#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "optimiser.hpp"
#include "relaxation_state.hpp"

// Moves of all generators, along steps and by relocations.

namespace gvd {

/// A move of all generators, before its diagram is known.
struct GeneratorMove {
  std::vector<SurfacePoint> to;
  std::vector<double> length;            ///< of every generator's path, mesh units
  TangentField step;                     ///< the steps, in the tangent planes at the ends of the paths
  std::vector<Turn> turns;               ///< parallel transport along the paths
  double scale = 1;                      ///< factor of all steps
  double prediction = 0;                 ///< predicted decrease of the energy by the whole steps; 0: no prediction
  std::int32_t held = 0;                 ///< number of generators that stay because they would collide
  std::int32_t relocated = 0;            ///< number of generators that moved to a distant place
  Acceleration by = Acceleration::none;  ///< the method that proposed the steps
};

/// Undoes moves that would let generators collide: `to[i]` becomes `from[i]` if another point of `to` is within `gap`
/// of it (Euclidean, mesh units) and point i has moved. The points of `from` must be farther apart than `gap`.
/// Returns the number of moves undone. Cost: O(m log m) in each of a few rounds, for m points of which few have nearly
/// the same x.
std::int32_t keep_apart(const Mesh& mesh, const std::vector<SurfacePoint>& from, double gap,
                        std::vector<SurfacePoint>& to);

/// Moves each generator of the state along the straight geodesic of its step, along its crease, or to its vertex in
/// `rests`, which may be empty. A generator that would come nearer than a small gap to another one stays (see
/// `keep_apart`). A generator that goes to rest has no step and no turn, because no history is kept for resting
/// generators.
/// Cost: O(faces crossed) and O(m log m).
GeneratorMove move_generators(const Mesh& mesh, const RelaxationState& state, const TangentField& steps,
                              const GeneratorConstraints& constraints = {}, const Rests& rests = {});

/// Vertices at which generators were expected to rest, but did not. A generator sent to such a vertex jumps there,
/// however short the steps are, and so does the energy, so no step would be accepted while the generator is sent there
/// again.
class RefusedRests {
 public:
  /// Finds generators of `moved` that lie at their vertex of `rests` but would move on. Records these vertices with the
  /// number of iterations so far, and removes them from `rests`. Returns whether there are any.
  bool note(std::size_t iterations, const RelaxationState& moved, Rests& rests);
  /// The rests, except the ones that were refused a few iterations ago.
  Rests allowed(std::size_t iterations, Rests rests) const;

 private:
  struct Refusal {
    std::optional<VertexId> vertex;
    std::size_t end = 0;  // the refusal holds before this iteration
  };
  std::vector<Refusal> refusals_;  // for each generator, or empty
};

/// A generator that moves to a distant place.
struct Relocation {
  std::size_t generator;
  SurfacePoint to;
  double gain = 0;  ///< estimated saving of energy, mesh units to the fourth
};

/// Plans moves of generators from cells with little energy to places with much energy, the most valuable move first.
///
/// In the best diagrams all cells have about the same area and energy. One after the other, generators of cells with
/// little energy go to the vertex that is farthest from all generators. This is farthest-point sampling, with straight
/// distances from the relocated generators. Adjacent cells that are given up together have at most half of the mean
/// cell area of their component, so that no holes arise. Every generator stays in its component of the mesh, and
/// generators that are not free do not move.
/// Cost: O(n + m log m) for n vertices and m generators, and for each vertex near the top of the heap, comparisons with
/// the places taken before it.
std::vector<Relocation> plan_relocations(const Mesh& mesh, const Density& density, const RelaxationState& state,
                                         const GeneratorConstraints& constraints = {});

/// The sum of the estimated savings.
double total_gain(const std::vector<Relocation>& relocations);

/// The move that makes the first `count` relocations. The lengths of its paths are straight distances in space.
GeneratorMove relocate_generators(const Mesh& mesh, const RelaxationState& state,
                                  const std::vector<Relocation>& relocations, std::size_t count);

}  // namespace gvd
