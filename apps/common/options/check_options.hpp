#pragma once

#include <string>
#include <vector>

#include "common/options/options.hpp"

namespace gvd::app {

/// Checks what no single option can: one source of generators, a format for standard input, options of the chosen
/// method, known extensions. Targets must be distinct, writable, and not read by the run.
///
/// `output_formats`: see CommandInfo. Throws Error{invalid_option}, or Error{unwritable_output} where the folder of a
/// target does not exist.
void check_options(const Options& options, const std::vector<std::string>& output_formats);

}  // namespace gvd::app
