#pragma once

#include <string>

#include "common/run/run.hpp"
#include "gvd/soup.hpp"

namespace gvd::app {

/// Reads and checks the mesh of INPUT. Notes each repair in one line, and reports the mesh and its defects.
/// Throws Error{unreadable_input} or Error{precondition} with the name of the input, and Error{unwritable_output} where
/// an output format can't hold the coordinates of the mesh. `standard_input`, if not null, receives what standard input
/// held where INPUT is that: it can be read only once.
CheckedMesh load_input(Run& run, std::string* standard_input = nullptr);

}  // namespace gvd::app
