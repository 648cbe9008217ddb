#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/run.hpp"

namespace gvd::app {

/// Runs `body` once for each of `runs`, and notes a table of the results. A run that fails prints the reason in a line,
/// and the next run begins; only an interruption ends all runs. Returns the exit code of the first failed run, or 0.
/// Writes a row of --summary after each run, so that the rows of all earlier runs are kept however the process ends.
/// Throws what `check_referred_files` throws, before the first run.
int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body);

/// Names and values of figures, as texts.
using Cells = std::vector<std::pair<std::string, std::string>>;

/// The result of one of several runs.
struct RunResult {
  std::string input;
  std::string result;  ///< in a few words
  double seconds = 0;
  int exit_code = 0;
  std::string error = {};  ///< the error message; empty if there is none
  Cells cells = {};        ///< figures of the report
  std::size_t files = 0;   ///< number of files written
};

/// Formats a table of the runs, with input, result, generators, E and energy if any run has them, and time. The first
/// line has the names of the columns, and each further line is a run. Figures that a run lacks, or that are not finite,
/// are "-".
std::vector<std::string> format_results(const std::vector<RunResult>& results);

/// The numbers, texts and booleans of a report under `input`, `diagram` and `results`, with names such as `input.area`.
Cells list_figures(const RunReport& report);

/// The table of --summary as CSV, with a row for each of `inputs`. Inputs beyond `results` have not run.
std::string format_summary(const std::vector<std::string>& inputs, const std::vector<RunResult>& results);

}  // namespace gvd::app
