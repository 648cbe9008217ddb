#include "common/run/run_several.hpp"

#include <fmt/format.h>

#include <chrono>

#include "common/run/interrupt.hpp"
#include "common/run/result_table.hpp"
#include "common/run/run_apart.hpp"

namespace gvd::app {

int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body) {
  std::vector<RunResult> results;
  int exit_code = kDone;
  for (const Options& options : runs) {
    const auto start = std::chrono::steady_clock::now();
    const RunEnd end = run_apart(command, options, body);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    const std::string result =
        end.exit_code == kDone ? end.summary : fmt::format("failed ({}: {})", end.exit_code, end.summary);
    results.push_back({options.input.path, result, end.figures, taken.count()});
    if (exit_code == kDone) exit_code = end.exit_code;
    if (interrupt_requested()) break;
  }
  // The last run may have been done when the signal came.
  if (exit_code == kDone && results.size() < runs.size()) exit_code = kInterrupted;
  Console console(command, {}, runs.front().quiet, false);
  for (const std::string& line : format_results(results)) console.note(line);
  return exit_code;
}

}  // namespace gvd::app
