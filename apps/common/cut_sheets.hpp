#pragma once

#include <functional>
#include <string>

#include "gvd/soup.hpp"

namespace gvd::app {

/// What a run found out about a face.
enum class Reach { reached, unreached, left_out };

/// Words behind a note on what no generator reaches: at how many edges the repair cut an unreached sheet off from one
/// that is reached. Empty where it was at none: what is not reached then is a component of its own.
/// Cost: O(n log n) where the repair cut non-manifold edges, else O(1).
std::string describe_cuts(const CheckedMesh& input, const std::function<Reach(FaceId)>& reach);

}  // namespace gvd::app
