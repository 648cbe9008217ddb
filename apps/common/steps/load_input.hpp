#pragma once

#include "common/run/run.hpp"
#include "gvd/soup.hpp"

namespace gvd::app {

/// Reads and checks the mesh of INPUT. Notes each repair in one line, and reports the mesh and its defects.
/// Throws Error{unreadable_input} or Error{precondition} with the name of the input, and Error{unwritable_output} where
/// an output format can't hold the coordinates of the mesh.
CheckedMesh load_input(Run& run);

}  // namespace gvd::app
