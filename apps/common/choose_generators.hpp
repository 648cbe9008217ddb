#pragma once

#include "common/options/options.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/progress.hpp"
#include "gvd/soup.hpp"

namespace gvd::app {

/// The generators that the options ask for, exactly as many as they say: those of a list, snapped to the surface, or
/// sampled ones. Throws what read_generators, resolve_generators and sample_generators throw.
ResolvedGenerators choose_generators(const CheckedMesh& input, const Options& options, const Progress& progress);

}  // namespace gvd::app
