#pragma once

#include <vector>

#include "common/run/run.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::app {

/// The generators that the options ask for, exactly as many as they say, and reports them.
/// Throws what read_generators, resolve_generators and sample_generators throw.
std::vector<SurfacePoint> make_generators(Run& run, const CheckedMesh& input);

}  // namespace gvd::app
