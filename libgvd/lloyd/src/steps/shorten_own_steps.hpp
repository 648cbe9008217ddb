#pragma once

#include <vector>

#include "state/generator_moves.hpp"
#include "state/relaxation_state.hpp"

namespace gvd {

/// Shortens the steps of the generators that went beyond the lowest point of their path. The energy's slopes at both
/// ends of a path tell how far (the secant); a step keeps a tenth at least and a half at most. `move` led from `before`
/// to `after`, whose energy is too large; `scales` are the factors of the steps. Returns whether there is such a
/// generator.
bool shorten_own_steps(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after,
                       std::vector<double>& scales);

}  // namespace gvd
