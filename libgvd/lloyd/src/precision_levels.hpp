#pragma once

#include <vector>

#include "gvd/lloyd.hpp"
#include "state/relaxation_state.hpp"

namespace gvd {

/// How a relaxation finds the cells: at first without diagrams, at last by those of `options.diagram`. Energies of
/// different levels must not be compared with each other: they differ by the errors at the bisectors.
std::vector<Precision> make_precision_levels(const LloydOptions& options);

}  // namespace gvd
