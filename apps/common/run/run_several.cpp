#include "common/run/run_several.hpp"

#include <fmt/format.h>

#include <chrono>

#include "common/run/interrupt.hpp"
#include "common/run/outcome.hpp"
#include "common/run/result_table.hpp"

namespace gvd::app {
namespace {

/// Errors of the input begin with its name already.
std::string named(const std::string& message, const std::string& input) {
  return message.starts_with(input) ? message : fmt::format("{}: {}", input, message);
}

struct Ended {
  Outcome outcome;
  RunResult result;
};

Ended run_one(const std::string& command, const Options& options, const std::function<void(Run&)>& body) {
  const auto start = std::chrono::steady_clock::now();
  Ended ended;
  {
    Console console(fmt::format("{}: {}", command, options.input.path), detect_console_style(), options.quiet,
                    options.verbose);
    Run run(command, options, console);
    limit_memory_of(options.compute);  // of each run anew
    ended.outcome = run_guarded([&] { body(run); });
    ended.result.figures = run.figures();
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  ended.result.input = options.input.path;
  const auto& [exit_code, message, summary] = ended.outcome;
  ended.result.result = exit_code == 0 ? summary : fmt::format("failed ({}: {})", exit_code, summary);
  ended.result.seconds = taken.count();
  return ended;
}

}  // namespace

int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body) {
  Console console(command, {}, runs.front().quiet, false);
  std::vector<RunResult> results;
  int exit_code = 0;
  for (const Options& options : runs) {
    const Ended ended = run_one(command, options, body);
    results.push_back(ended.result);
    if (!ended.outcome.message.empty()) console.error(named(ended.outcome.message, options.input.path));
    if (exit_code == 0) exit_code = ended.outcome.exit_code;
    if (interrupt_requested()) break;
  }
  for (const std::string& line : format_results(results)) console.note(line);
  return exit_code;
}

}  // namespace gvd::app
