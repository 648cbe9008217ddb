#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "common/options/options.hpp"
#include "common/run/console.hpp"
#include "common/run/interrupt.hpp"
#include "common/run/result_table.hpp"
#include "common/run/run_report.hpp"
#include "gvd/progress.hpp"

namespace gvd::app {

/// Largest resident memory of this process so far, in bytes.
std::int64_t peak_memory_bytes();

/// Limits the memory of a run, by its options.
void limit_memory_of(const ComputeOptions& compute);

/// One run of a command: its options, its console and its report.
class Run {
 public:
  Run(const std::string& command, Options options, Console& console);

  const Options& options() const { return options_; }
  Console& console() { return console_; }
  /// The document of `--report`. Each step of a run adds its figures.
  RunReport& report() { return report_; }

  /// For the table of several runs.
  RunFigures& figures() { return figures_; }

  /// For the `progress` fields of the library: draws the bar, and cancels after a signal. Valid while the run lives.
  Progress progress();

  /// Reports and, where verbose, prints the wall time of a step.
  void report_time(std::string_view step, double milliseconds);

  /// Runs `work` and reports its wall time under the name `step`.
  /// Throws Error{interrupted} where a signal came before.
  template <class Work>
  decltype(auto) timed(std::string_view step, Work&& work) {
    const Stopwatch stopwatch(*this, step);
    return std::forward<Work>(work)();
  }

 private:
  /// Reports the time from its construction to its end.
  class Stopwatch {
   public:
    Stopwatch(Run& run, std::string_view step);
    ~Stopwatch();
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

   private:
    Run& run_;
    std::string step_;
    std::chrono::steady_clock::time_point start_;
  };

  Options options_;
  Console& console_;
  RunReport report_;
  RunFigures figures_;
};

}  // namespace gvd::app
