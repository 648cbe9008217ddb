#pragma once

#include <string_view>

#include "gvd/lloyd.hpp"

// What files and results call the iterations of a relaxation.
namespace gvd {

/// The measure of an iteration's energy: the name of a method, or `sampled` without a diagram.
std::string_view measure_name(const LloydIteration& iteration);

/// How the step of an iteration was found, in one word.
std::string_view step_name(const LloydIteration& iteration);

}  // namespace gvd
