// A run of a command: times and progress, which the library asks for by callbacks.
//
// The library reads no clock and prints nothing. A step's time is reported when its StepTimes ends, after an exception
// too. The progress callback draws the bar and cancels the library's work once a signal has come.

#include "common/run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/process.hpp"

namespace gvd::app {

StepTimes::StepTimes(Run& run) : run_(run) { check_interrupt(); }

StepTimes::~StepTimes() {
  stop();
  for (const auto& [step, sum] : sums_) run_.report_time(step, std::chrono::duration<double, std::milli>(sum).count());
}

void StepTimes::start(std::string_view step) {
  stop();
  const auto found = std::find_if(sums_.begin(), sums_.end(), [&](const auto& sum) { return sum.first == step; });
  current_ = found - sums_.begin();
  if (found == sums_.end()) sums_.emplace_back(step, Clock::duration::zero());
  started_ = Clock::now();
}

void StepTimes::stop() {
  if (!sums_.empty()) sums_[current_].second += Clock::now() - started_;
}

Progress Run::progress() {
  return [this](std::string_view step, double fraction) {
    console_.bar(step, fraction);
    return !interrupt_requested();
  };
}

void Run::report_time(std::string_view step, double milliseconds) {
  console_.clear_bar();
  console_.detail(fmt::format("{}: {:.1f} ms", step, milliseconds));
  report_.set_time(step, milliseconds);
}

}  // namespace gvd::app
