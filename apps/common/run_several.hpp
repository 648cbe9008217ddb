#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/run.hpp"

namespace gvd::app {

/// Runs `body` once for each of `runs`, and notes a table of the results. A run that fails says why in a line, and the
/// next one begins; only an interruption ends all. Returns the exit code of the first run that failed, or 0.
int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body);

/// One of several runs.
struct RunResult {
  std::string input;
  std::string result;  ///< in a few words
  RunFigures figures;
  double seconds = 0;
};

/// A table of the runs: input, result, regions, E and energy where a run has them, and time. A line each, the first one
/// with the names of the columns. Figures that a run lacks, or that are not finite, are "-".
std::vector<std::string> format_results(const std::vector<RunResult>& results);

}  // namespace gvd::app
