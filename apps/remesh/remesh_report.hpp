#pragma once

#include "common/run/run.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"

// What gvd-remesh notes and reports: the report's `results`, `diagram` and `generators`, and its own options.
namespace gvd::app {

/// `options.max_added` must be the bound that holds for the run, given or not.
void report_remesh_options(Run& run, const RemeshOptions& options);

/// The certificate and the quality of a remesh, its diagram, and the generators that were added. `options`: those that
/// gave the result, with the bound as above.
void report_remesh(Run& run, const Mesh& mesh, const RemeshResult& result, const RemeshOptions& options);

}  // namespace gvd::app
