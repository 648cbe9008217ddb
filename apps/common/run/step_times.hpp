#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/run/run.hpp"

namespace gvd::app {

/// Sums the wall times of steps that alternate within one call of the library, and reports each sum at its end.
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

}  // namespace gvd::app
