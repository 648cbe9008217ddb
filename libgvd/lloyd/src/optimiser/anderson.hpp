#pragma once

#include "step_history.hpp"
#include "tangent_field.hpp"

namespace gvd {

/// The step of Anderson's acceleration of the fixed-point iteration whose plain step is `residual`.
///
/// Source:  Walker and Ni, Anderson acceleration for fixed-point iterations, 2011.
/// Inputs:  pairs of steps and changes of the residual; `residual`: the ways to the centroids, mesh units.
/// Returns: residual - sum over the pairs of c (step + change), where the factors c make |residual - sum c change|
///          least. Without pairs, the residual.
/// Cost: O(pairs^2 x generators).
TangentField anderson_step(const StepHistory& history, const TangentField& residual);

}  // namespace gvd
