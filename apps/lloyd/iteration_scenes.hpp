#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/io/view.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "lloyd/relaxation_trace.hpp"

namespace gvd::app {

/// The scenes of the page: the relaxed generators, the start, and iterations between them, evenly over the run, at most
/// twelve together. `options`: of their diagrams, which are computed but for the last.
std::vector<ViewScene> make_iteration_scenes(const Mesh& mesh, const LloydResult& relaxed, const RelaxationTrace& trace,
                                             const DiagramOptions& options);

}  // namespace gvd::app
