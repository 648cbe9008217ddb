#pragma once

#include <random>
#include <string>

#include "gvd/generator_list.hpp"
#include "support/refusal.hpp"

namespace gvd::test {

/// A list of the name "list".
GeneratorList parse(const std::string& text, GeneratorFormat format = GeneratorFormat::text);

/// In [0, 1].
double uniform(std::mt19937& random);

/// A point in a face or, one time in four, on an edge.
SurfacePoint random_point(const Mesh& mesh, std::mt19937& random);

}  // namespace gvd::test
