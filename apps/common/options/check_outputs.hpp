#pragma once

#include <string>
#include <vector>

#include "common/options/options.hpp"

namespace gvd::app {

/// Refuses outputs that the run could not write or must not, before it starts. By name: an unknown extension, a file
/// that another option names or that the run reads. By the system: a missing folder, no write permission, a closed
/// standard output, binary data for a terminal.
///
/// `formats`: extensions without the dot that `-o` takes.
/// Throws Error{invalid_option}, or Error{unwritable_output} where the system refuses.
void check_outputs(const Options& options, const std::vector<std::string>& formats);

}  // namespace gvd::app
