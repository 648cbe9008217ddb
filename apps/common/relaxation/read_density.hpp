#pragma once

#include "common/options/options.hpp"
#include "common/run/run.hpp"
#include "gvd/density.hpp"
#include "gvd/soup.hpp"

namespace gvd::app {

/// The density that the options ask for. Throws Error where there is neither a file nor a property of that name, where
/// a number is missing or too much, and where one is not above 0.
Density read_density(Run& run, const CheckedMesh& input, const ConstraintOptions& options);

}  // namespace gvd::app
