#pragma once

#include <vector>

#include "common/run/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::app {

/// Computes the diagram by the method that the options name, and reports it. Throws what compute_diagram throws.
Diagram build_diagram(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& generators);

/// Notes and reports the figures of a diagram.
void report_diagram(Run& run, const Diagram& diagram);

}  // namespace gvd::app
