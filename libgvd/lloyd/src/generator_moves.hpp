#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "optimiser.hpp"
#include "relaxation_state.hpp"

// Moves of all generators: along steps, and by relocations.

namespace gvd {

/// A move of all generators, before its diagram is known.
struct GeneratorMove {
  std::vector<SurfacePoint> to;
  std::vector<double> length;            ///< of every generator's path, mesh units
  TangentField step;                     ///< of the paths, in the tangent planes at their ends
  std::vector<Turn> turns;               ///< parallel transport along the paths
  double scale = 1;                      ///< factor of all steps
  double prediction = 0;                 ///< decrease of the energy by the whole steps, as predicted; 0: none was
  std::int32_t held = 0;                 ///< generators that stay because they would collide
  std::int32_t relocated = 0;            ///< generators that left their place for a distant one
  Acceleration by = Acceleration::none;  ///< what proposed the steps
};

/// Undoes moves that would let generators collide: `to[i]` becomes `from[i]` if another point of `to` is within `gap`
/// of it (Euclidean, mesh units) and point i has moved. The points of `from` must be farther apart than `gap`.
/// Returns the number of moves undone. Cost: O(m log m) in each of a few rounds, for m points that are not crowded
/// along x.
std::int32_t keep_apart(const Mesh& mesh, const std::vector<SurfacePoint>& from, double gap,
                        std::vector<SurfacePoint>& to);

/// Moves each generator of the state along the straight geodesic of its step, or along its crease; or to its vertex of
/// `rests`, which may be empty. One that would come nearer than a small gap to another one stays (see keep_apart). One
/// that goes to rest has no step and turns nothing, because no history is kept of resting generators.
/// Cost: O(faces crossed) and O(m log m).
GeneratorMove move_generators(const Mesh& mesh, const RelaxationState& state, const TangentField& steps,
                              const GeneratorConstraints& constraints = {}, const Rests& rests = {});

/// Vertices at which generators seemed to rest, but did not. A generator that goes there jumps, however short the steps
/// are, and so does the energy: no step would be accepted while it is sent there again.
class RefusedRests {
 public:
  /// Notes the vertices of `rests` at which generators of `moved` lie that would go on, after so many iterations, and
  /// removes them. Returns whether there are any.
  bool note(std::size_t iterations, const RelaxationState& moved, Rests& rests);
  /// The rests but those that were refused a few iterations ago.
  Rests allowed(std::size_t iterations, Rests rests) const;

 private:
  struct Refusal {
    std::optional<VertexId> vertex;
    std::size_t end = 0;  // the iteration up to which it holds
  };
  std::vector<Refusal> refusals_;  // of each generator, or empty
};

/// A generator that leaves its place for another one.
struct Relocation {
  std::size_t generator;
  SurfacePoint to;
  double gain = 0;  ///< estimate of the energy that is saved, mesh units to the fourth
};

/// Moves from where cells are worth little to where they cost much, the most valuable first.
///
/// In the best diagrams all cells have about the same area and energy. Generators of cells with little energy go to the
/// vertex that is farthest from all generators, one after the other: farthest-point sampling, in straight distances
/// from those that came before. Cells that are given up together have at most half of the mean area of their
/// component wherever they adjoin, so that no holes arise. Every generator stays in its component of the mesh, and
/// those that are not free stay where they are.
/// Cost: O(n + m log m) for n vertices and m generators, and, for each vertex at places that were taken, the comparison
/// with those taken before it.
std::vector<Relocation> plan_relocations(const Mesh& mesh, const Density& density, const RelaxationState& state,
                                         const GeneratorConstraints& constraints = {});

/// The sum of the estimates.
double total_gain(const std::vector<Relocation>& relocations);

/// The move of the first `count` relocations. Lengths are straight through space.
GeneratorMove relocate_generators(const Mesh& mesh, const RelaxationState& state,
                                  const std::vector<Relocation>& relocations, std::size_t count);

}  // namespace gvd
