#pragma once

#include <vector>

#include "gvd/sampling.hpp"

namespace gvd {

/// Sampling::farthest: `count` vertices, each the farthest from all before it. The caller has checked the options.
std::vector<SurfacePoint> sample_farthest(const Mesh& mesh, const SamplingOptions& options);

/// Sampling::covering_radius: farthest vertices until no point is farther than `radius` from its nearest generator.
/// The caller has checked the options.
std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options);

}  // namespace gvd
