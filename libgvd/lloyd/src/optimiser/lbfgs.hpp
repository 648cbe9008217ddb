#pragma once

#include <functional>

#include "step_history.hpp"
#include "tangent_field.hpp"

namespace gvd {

/// The product of an approximate inverse Hessian and a field: symmetric and positive definite.
using InverseHessian = std::function<TangentField(const TangentField&)>;

/// The direction of descent of the L-BFGS method: minus the product of the approximate inverse Hessian and `gradient`.
///
/// Source:  Nocedal and Wright, Numerical Optimization, 2006, algorithm 7.4 (two-loop recursion).
/// Inputs:  pairs of steps and changes of the gradient, each of positive curvature (step . change > 0); `initial`: the
///          inverse Hessian before the pairs. The latest pair gives it a factor.
/// Returns: a direction d with d . gradient < 0, unless the gradient is zero. Without pairs, -initial(gradient).
/// Cost: O(pairs x generators), and two calls of `initial`.
TangentField lbfgs_direction(const StepHistory& history, const TangentField& gradient, const InverseHessian& initial);

}  // namespace gvd
