#pragma once

#include <vector>

#include "state/generator_moves.hpp"
#include "state/relaxation_state.hpp"

namespace gvd {

/// Shortens the steps of those generators that went beyond the lowest point of their path, by what the energy's slopes
/// at both ends of the path tell (the secant, to a tenth or a half). `move` led from `before` to `after`, whose energy
/// is too large; `scales` are the factors of the steps. Returns whether there is such a generator.
bool shorten_own_steps(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after,
                       std::vector<double>& scales);

}  // namespace gvd
