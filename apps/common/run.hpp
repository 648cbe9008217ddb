#pragma once

#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/console.hpp"
#include "common/interrupt.hpp"
#include "common/options.hpp"
#include "gvd/io/run_report.hpp"
#include "gvd/progress.hpp"

namespace gvd::app {

/// What the options say of every diagram of a run; defaults where they say nothing, and no progress.
DiagramOptions make_diagram_options(const ComputeOptions& compute);

/// Largest resident memory of this process so far, in bytes.
std::int64_t peak_memory_bytes();

/// One run of a command: what it was asked, whom it tells, what it reports.
class Run {
 public:
  Run(const std::string& command, Options options, Console& console);

  const Options& options() const { return options_; }
  Console& console() { return console_; }
  /// What `--report` will hold. The steps of pipeline.hpp and `timed` fill their parts.
  RunReport& report() { return report_; }
  /// The report's `options`: the shared ones are there already, a command adds its own.
  nlohmann::ordered_json& reported_options() { return reported_options_; }
  /// The report's `results`: the command's own figures.
  nlohmann::ordered_json& results() { return results_; }

  /// For the library's `progress` fields: draws the bar, and cancels once a signal has come. Valid while the run lives.
  Progress progress();

  /// Runs `work`, and reports its wall time, in milliseconds, under the name `step`. A signal before or after it ends
  /// the run.
  template <class Work>
  decltype(auto) timed(std::string_view step, Work&& work) {
    const Stopwatch stopwatch(*this, step);
    return std::forward<Work>(work)();
  }

 private:
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
  nlohmann::ordered_json reported_options_;
  nlohmann::ordered_json results_ = nlohmann::ordered_json::object();
};

}  // namespace gvd::app
