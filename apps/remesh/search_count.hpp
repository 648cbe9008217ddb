#pragma once

#include <cstdint>
#include <functional>

#include "common/run/run.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"

namespace gvd::app {

/// Searches for the fewest generators that keep the distance of `--error`, and reports the trials. `remesh_with`: makes
/// the result with so many generators, in a run of its own that prints nothing.
/// Throws Error{no_valid_result} where no number that was tried is enough, and what the first trial throws.
std::int32_t search_count(Run& run, const Mesh& mesh,
                          const std::function<RemeshResult(Run& trial, std::int32_t count)>& remesh_with);

}  // namespace gvd::app
