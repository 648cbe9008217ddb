#pragma once

#include <cstdint>
#include <vector>

#include "constraints.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "relaxation_state.hpp"
#include "tangent_field.hpp"

namespace gvd {

/// A move of all generators, before its diagram is known.
struct GeneratorMove {
  std::vector<SurfacePoint> to;
  std::vector<double> length;            ///< of every generator's path, mesh units
  TangentField step;                     ///< of the paths, in the tangent planes at their ends
  std::vector<Turn> turns;               ///< parallel transport along the paths
  double scale = 1;                      ///< factor of all steps
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

/// Whether generators beside a vertex where they would rest (RelaxationState::rest) go there instead of along their
/// step.
enum class GoToRest { no, yes };

/// Moves each generator of the state along the straight geodesic of its step, or along its crease. One that would come
/// nearer than a small gap to another one stays (see keep_apart). One that goes to rest has no step and turns nothing,
/// because no history is kept of resting generators.
/// Cost: O(faces crossed) and O(m log m).
GeneratorMove move_generators(const Mesh& mesh, const RelaxationState& state, const TangentField& steps,
                              const GeneratorConstraints& constraints = {}, GoToRest rests = GoToRest::no);

}  // namespace gvd
