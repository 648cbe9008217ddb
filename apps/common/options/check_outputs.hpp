#pragma once

#include <string>
#include <vector>

#include "common/options/options.hpp"

namespace gvd::app {

/// Refuses, before the run starts, outputs that it could not write or must not: an unknown extension, a file that
/// another option names or that the run reads, a folder that is missing, a file or folder without write permission,
/// a standard output that is closed, binary data for a terminal.
///
/// `formats`: extensions without the dot that `-o` takes.
/// Throws Error{invalid_option}, or Error{unwritable_output} where the system refuses.
void check_outputs(const Options& options, const std::vector<std::string>& formats);

}  // namespace gvd::app
