#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gvd::app {

/// The figures of a run for the table of several. Each step fills in what it computes.
struct RunFigures {
  std::optional<std::int64_t> regions;
  std::optional<double> error_integral;  ///< E of --verify, mesh units squared
  std::optional<double> energy;          ///< mesh units to the fourth
};

/// One of several runs.
struct RunResult {
  std::string input;
  std::string result;  ///< in a few words
  RunFigures figures;
  double seconds = 0;
};

/// A table of the runs: input, result, regions, E and energy where a run has them, and time. A line each, the first one
/// with the names of the columns. Figures that a run lacks are "-".
std::vector<std::string> format_results(const std::vector<RunResult>& results);

}  // namespace gvd::app
