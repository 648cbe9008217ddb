#pragma once

#include <functional>

#include "tangent_field.hpp"

namespace gvd {

/// The product of f(A) and `b`, where A is the symmetric matrix of `multiply`, and f acts on its eigenvalues.
///
/// Source:  Golub and Van Loan, Matrix Computations, 2013, section 10.1 (Lanczos process), with reorthogonalisation.
/// Returns: the best approximation in the space of b, A b, ... A^(steps - 1) b; exact if that space is invariant.
/// Cost: `steps` products with A, O(steps^2 x generators).
TangentField apply_matrix_function(const std::function<TangentField(const TangentField&)>& multiply,
                                   const std::function<double(double)>& f, const TangentField& b, int steps);

}  // namespace gvd
