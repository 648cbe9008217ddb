#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/run.hpp"

namespace gvd::app {

/// Runs `body` once for each of `runs`, and notes a table of the results. A run that fails says why in a line, and the
/// next one begins; only an interruption ends all. Returns the exit code of the first run that failed, or 0. Writes
/// a row of --summary after each run, so that whatever ends the process leaves the rows of all runs before.
/// Throws what `check_referred_files` throws, before the first run.
int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body);

/// Names and values of figures, as texts.
using Cells = std::vector<std::pair<std::string, std::string>>;

/// One of several runs.
struct RunResult {
  std::string input;
  std::string result;  ///< in a few words
  double seconds = 0;
  int exit_code = 0;
  std::string error = {};  ///< the message; empty where there is none
  Cells cells = {};        ///< figures of the report
  std::size_t files = 0;   ///< that it wrote
};

/// A table of the runs: input, result, generators, E and energy where a run has them, and time. A line each, the first
/// one with the names of the columns. Figures that a run lacks, or that are not finite, are "-".
std::vector<std::string> format_results(const std::vector<RunResult>& results);

/// A report's numbers, texts and truth values under `input`, `diagram` and `results`, with names such as `input.area`.
Cells list_figures(const RunReport& report);

/// The table of --summary as CSV: a row for each of `inputs`, of which those behind `results` have not run.
std::string format_summary(const std::vector<std::string>& inputs, const std::vector<RunResult>& results);

}  // namespace gvd::app
