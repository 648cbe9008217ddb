#pragma once

#include <cstdint>
#include <functional>

#include "common/run/run.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"

namespace gvd::app {

/// The fewest generators of `--error`, and reports the trials. `remesh_with`: the result with so many generators, in a
/// run of its own that prints nothing.
/// Throws Error{no_valid_result} where no number of trials is enough.
std::int32_t search_count(Run& run, const Mesh& mesh,
                          const std::function<RemeshResult(Run& trial, std::int32_t count)>& remesh_with);

}  // namespace gvd::app
