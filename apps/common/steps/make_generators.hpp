#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/run/run.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::app {

/// The generators that the options ask for, exactly as many as they say, and reports them. `count`: of sampled ones,
/// instead of the options'.
/// Throws what read_generators, resolve_generators and sample_generators throw.
std::vector<SurfacePoint> make_generators(Run& run, const CheckedMesh& input, std::optional<std::int32_t> count = {});

}  // namespace gvd::app
