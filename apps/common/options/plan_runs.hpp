#pragma once

#include <vector>

#include "common/options/options.hpp"

namespace gvd::app {

/// The options of each run: those of a command line, with one of its inputs. With --output-dir each run writes a file
/// of each format into the folder, named after its input.
std::vector<Options> plan_runs(const Options& options);

}  // namespace gvd::app
