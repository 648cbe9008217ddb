#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/console.hpp"
#include "common/options/options.hpp"
#include "common/run_report.hpp"
#include "gvd/progress.hpp"

namespace gvd::app {

class Run;

/// Sums the wall times of steps that may alternate, and reports each sum at its end.
class StepTimes {
 public:
  /// Throws Error{interrupted} where a signal came before.
  explicit StepTimes(Run& run);
  ~StepTimes();
  StepTimes(const StepTimes&) = delete;
  StepTimes& operator=(const StepTimes&) = delete;

  /// Ends the current step and starts `step`, or starts it again.
  void start(std::string_view step);

 private:
  using Clock = std::chrono::steady_clock;
  void stop();

  Run& run_;
  std::vector<std::pair<std::string, Clock::duration>> sums_;  ///< in the order of their first starts
  std::size_t current_ = 0;
  Clock::time_point started_{};
};

/// The figures of a run for the table of several.
struct RunFigures {
  std::optional<std::int64_t> regions;
  std::optional<double> error_integral;  ///< E of --verify, mesh units squared
  std::optional<double> energy;          ///< mesh units to the fourth
};

/// One run of a command: its options, console and report. Only the body of the run holds it. Steps take values and
/// return what the body reports.
class Run {
 public:
  Run(const std::string& command, Options options, Console& console)
      : options_(std::move(options)), console_(console), report_(command, options_) {}

  const Options& options() const { return options_; }
  Console& console() { return console_; }
  /// The document of `--report`.
  RunReport& report() { return report_; }
  RunFigures& figures() { return figures_; }

  /// For the `progress` fields of the library: draws the bar, and cancels after a signal. Valid while the run lives.
  Progress progress();

  /// Reports and, where verbose, prints the wall time of a step.
  void report_time(std::string_view step, double milliseconds);

  /// Runs `work` and reports its wall time under the name `step`.
  /// Throws Error{interrupted} where a signal came before.
  template <class Work>
  decltype(auto) timed(std::string_view step, Work&& work) {
    StepTimes times(*this);
    times.start(step);
    return std::forward<Work>(work)();
  }

 private:
  Options options_;
  Console& console_;
  RunReport report_;
  RunFigures figures_;
};

}  // namespace gvd::app
