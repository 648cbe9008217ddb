#include "common/run/step_times.hpp"

#include <algorithm>

namespace gvd::app {

StepTimes::StepTimes(Run& run) : run_(run) { check_interrupt(); }

StepTimes::~StepTimes() {
  stop();
  for (const auto& [step, sum] : sums_) run_.report_time(step, std::chrono::duration<double, std::milli>(sum).count());
}

void StepTimes::start(std::string_view step) {
  stop();
  const auto found = std::find_if(sums_.begin(), sums_.end(), [&](const auto& sum) { return sum.first == step; });
  current_ = static_cast<std::size_t>(found - sums_.begin());
  if (found == sums_.end()) sums_.emplace_back(step, Clock::duration::zero());
  started_ = Clock::now();
}

void StepTimes::stop() {
  if (!sums_.empty()) sums_[current_].second += Clock::now() - started_;
}

}  // namespace gvd::app
