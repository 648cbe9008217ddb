#pragma once

#include <string>
#include <vector>

#include "common/options/options.hpp"

namespace gvd::app {

/// The formats of `-o` of a command.
struct OutputFormats {
  std::vector<std::string> extensions;  ///< without their dots
  bool materials = true;                ///< whether an .obj gets an .mtl with its colours beside it
};

/// Checks the inputs together, and the options that read standard input or a pipe. `options.list` tells which options
/// read files. Throws Error{invalid_option}.
void check_inputs(const Options& options, const OutputFormats& formats);

/// Refuses features that this build lacks, and outputs that the run could not or must not write: an unknown extension,
/// a file that another option names or that the run reads, a missing folder, no write permission, a closed standard
/// output, binary data for a terminal.
///
/// Throws Error{invalid_option}, or Error{unwritable_output} if the system refuses.
void check_outputs(const Options& options, const OutputFormats& formats);

/// The options of each run: the options of the command line, with one of its inputs. With --output-dir each run writes
/// a file of each format into the folder, named after its input.
std::vector<Options> plan_runs(const Options& options);

}  // namespace gvd::app
