#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/console.hpp"
#include "common/interrupt.hpp"
#include "common/options.hpp"
#include "gvd/progress.hpp"

namespace gvd::app {

/// Largest resident memory of this process so far, in bytes.
std::int64_t peak_memory_bytes();

/// One run of a command: what it was asked, whom it tells, what its steps took.
class Run {
 public:
  /// Wall time of a step, in milliseconds.
  struct Timing {
    std::string step;
    double milliseconds = 0;
  };

  Run(std::string command, Options options, Console& console);

  const std::string& command() const { return command_; }
  const Options& options() const { return options_; }
  Console& console() { return console_; }
  const std::vector<Timing>& timings() const { return timings_; }

  /// For the library's `progress` fields: draws the bar, and cancels once a signal has come. Valid while the run lives.
  Progress progress();

  /// Runs `work`, and keeps its wall time under the name `step`. A signal before or after it ends the run.
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

  std::string command_;
  Options options_;
  Console& console_;
  std::vector<Timing> timings_;
};

}  // namespace gvd::app
