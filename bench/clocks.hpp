#pragma once

#include <time.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/progress.hpp"

// Clocks and medians of all programs of this folder. A figure of time is the median of several runs: unlike the mean it
// is not moved by the few runs that another process disturbs.

namespace gvd::bench {

/// The median of one value or more; of an even number the mean of the two in the middle. Cost: O(n log n).
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// The median of each figure over `runs` >= 1 runs; a figure is a function that measures once and returns a number.
/// The figures take turns, so that a slow phase of the machine affects all of them and hardly changes their ratios.
template <class... Figure>
std::array<double, sizeof...(Figure)> measure_medians(int runs, const Figure&... figures) {
  std::array<std::vector<double>, sizeof...(Figure)> values;
  for (int run = 0; run < runs; ++run) {
    auto own = values.begin();
    ((own++)->push_back(figures()), ...);
  }
  std::array<double, sizeof...(Figure)> medians{};
  std::transform(values.begin(), values.end(), medians.begin(), median);
  return medians;
}

/// Processor time of this thread in milliseconds. Wall-clock time would also count the time slices of other processes,
/// more of them for long runs than for short ones, and so distort ratios.
inline double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

/// Processor time that this thread spends in `work`, milliseconds.
template <class Work>
double cpu_milliseconds(const Work& work) {
  const double start = cpu_milliseconds();
  work();
  return cpu_milliseconds() - start;
}

/// Wall-clock time of `work`, milliseconds: for work of several threads, whose processor times would add up.
template <class Work>
double wall_milliseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Processor times in milliseconds, by step.
using StepTimes = std::map<std::string, double>;

/// Times the steps that a run names through its progress callback (gvd/diagram_steps.hpp): a step lasts until another
/// one is named. A step that is named again goes on.
class StepClock {
 public:
  /// The callback; valid while the clock exists.
  Progress progress() {
    return [this](std::string_view step, double) {
      if (step != current_) {
        end_step();
        current_ = step;
      }
      return true;
    };
  }

  /// Ends the last step. Returns the total time of each step.
  StepTimes finish() {
    end_step();
    return times_;
  }

 private:
  void end_step() {
    const double now = cpu_milliseconds();
    if (!current_.empty()) times_[current_] += now - start_;
    start_ = now;
  }

  StepTimes times_;
  std::string current_;  // the step that runs; empty before the first one
  double start_ = cpu_milliseconds();
};

}  // namespace gvd::bench
