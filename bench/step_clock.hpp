#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cpu_clock.hpp"
#include "gvd/progress.hpp"

namespace gvd::bench {

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
