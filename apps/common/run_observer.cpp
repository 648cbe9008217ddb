// What an operation tells, for the console and the report of a run.

#include "common/run_observer.hpp"

#include <algorithm>
#include <exception>

#include "common/process.hpp"

namespace gvd::app {

RunObserver::RunObserver(Run& run) : run_(run) { threads = run.options().compute.threads; }

// Nothing is reported while an exception is on its way: there may be no memory for it.
RunObserver::~RunObserver() {
  if (std::uncaught_exceptions() > 0) return;
  for (const Timed& timed : steps_) {
    if (timed.times > 1) report(timed);
  }
}

void RunObserver::report(const Timed& timed) {
  run_.report_time(timed.step, std::chrono::duration<double, std::milli>(timed.sum).count());
}

bool RunObserver::progress(std::string_view step, double fraction) {
  run_.console().bar(step, fraction);
  return !interrupt_requested();
}

void RunObserver::enter(std::string_view step) {
  check_interrupt();
  release_freed_memory();
  const auto found = std::ranges::find(steps_, step, &Timed::step);
  entered_.push_back(std::size_t(found - steps_.begin()));
  if (found == steps_.end()) steps_.push_back({std::string(step)});
  steps_[entered_.back()].started = Clock::now();
}

void RunObserver::leave() {
  Timed& left = steps_[entered_.back()];
  left.sum += Clock::now() - left.started;
  entered_.pop_back();
  if (std::uncaught_exceptions() == 0 && ++left.times == 1) report(left);
}

void RunObserver::note(const std::string& text) { run_.note(text); }

void RunObserver::detail(const std::string& text) { run_.console().detail(run_.spelled(text)); }

void RunObserver::status(const std::string& text) { run_.console().set_status(text); }

}  // namespace gvd::app
