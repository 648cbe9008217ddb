#pragma once

#include <functional>
#include <random>
#include <string>

#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"

namespace gvd::test {

/// A list of the name "list".
GeneratorList parse(const std::string& text, GeneratorFormat format = GeneratorFormat::text);

/// The message, of one line, with which `work` fails. Checks the code of the error.
std::string refusal(const std::function<void()>& work, ErrorCode code);

/// In [0, 1].
double uniform(std::mt19937& random);

/// A point in a face or, one time in four, on an edge.
SurfacePoint random_point(const Mesh& mesh, std::mt19937& random);

}  // namespace gvd::test
