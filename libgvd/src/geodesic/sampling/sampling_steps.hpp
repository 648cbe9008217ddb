#pragma once

#include <vector>

#include "gvd/sampling.hpp"

namespace gvd {

// The kinds of sampling; `sample_generators` has checked the options.

std::vector<SurfacePoint> sample_farthest(const Mesh& mesh, const SamplingOptions& options);
std::vector<SurfacePoint> sample_covering(const Mesh& mesh, const SamplingOptions& options);
std::vector<SurfacePoint> sample_poisson(const Mesh& mesh, const SamplingOptions& options);

/// The side of the equilateral triangles that `count` generators would span if they lay evenly on `area`: mesh units.
double even_spacing(double area, std::int64_t count);

/// Most vertices that splitting long edges may add for the sake of spacing: a bound on memory where faces are slivers,
/// in proportion to mesh and generators, and far from where it would bind otherwise.
std::int64_t most_splits(const Mesh& mesh, std::int64_t count);

}  // namespace gvd
