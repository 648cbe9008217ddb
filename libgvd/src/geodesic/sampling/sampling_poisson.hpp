#pragma once

#include <vector>

#include "gvd/sampling.hpp"

namespace gvd {

/// Sampling::poisson: `count` points with blue-noise spacing. The caller has checked the options.
std::vector<SurfacePoint> sample_poisson(const Mesh& mesh, const SamplingOptions& options);

}  // namespace gvd
