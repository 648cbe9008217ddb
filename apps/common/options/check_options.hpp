#pragma once

#include "common/options/check_outputs.hpp"
#include "common/options/options.hpp"

namespace gvd::app {

/// Checks what no single option can: one source of generators, a format for standard input, options of the chosen
/// method, known extensions. Targets must be distinct, writable, and not read by the run.
///
/// Throws Error{invalid_option}, or Error{unwritable_output} where the folder of a
/// target does not exist.
void check_options(const Options& options, const OutputFormats& formats);

}  // namespace gvd::app
