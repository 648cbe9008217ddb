#pragma once

#include <string>

#include "common/run.hpp"
#include "gvd/soup.hpp"

namespace gvd::app {

/// Reads what options name: points, curves, and numbers out of files or of properties of INPUT, so that operations find
/// values. Throws Error{unreadable_input} with the option where a name is neither a file nor a property, and what the
/// readers throw.
void read_given_files(Run& run, const CheckedMesh& input);

}  // namespace gvd::app
