#pragma once

#include "common/run/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::app {

/// With `--verify`: measures the error of the diagram against exact distances, notes and reports it. Otherwise nothing.
void verify(Run& run, const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd::app
