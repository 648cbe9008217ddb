#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/progress.hpp"

namespace gvd::bench {

/// The median of one value or more; of an even number the mean of the two in the middle. Cost: O(n log n).
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Processor time of this thread in milliseconds. Wall-clock time would also count the time slices of other processes,
/// more of them for long runs than for short ones, and so distort ratios.
inline double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

/// Processor times in milliseconds, by step.
using StepTimes = std::vector<std::pair<std::string, double>>;

/// Times the steps that a run names through its progress callback (gvd/diagram_steps.hpp): a step lasts until another
/// one is named.
class StepClock {
 public:
  /// The callback; valid while the clock exists.
  Progress progress() {
    return [this](std::string_view step, double) {
      if (times_.empty() || times_.back().first != step) begin(step);
      return true;
    };
  }

  /// Ends the last step. Returns the steps in the order in which they were first named, each with its total time.
  StepTimes finish() {
    end_step();
    StepTimes merged;
    for (const auto& [step, milliseconds] : times_) {
      auto it = merged.begin();
      while (it != merged.end() && it->first != step) ++it;
      if (it == merged.end()) {
        merged.emplace_back(step, milliseconds);
      } else {
        it->second += milliseconds;
      }
    }
    return merged;
  }

 private:
  void begin(std::string_view step) {
    end_step();
    times_.emplace_back(step, 0.0);
  }

  void end_step() {
    const double now = cpu_milliseconds();
    if (!times_.empty()) times_.back().second += now - start_;
    start_ = now;
  }

  StepTimes times_;
  double start_ = cpu_milliseconds();
};

}  // namespace gvd::bench
