#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/run.hpp"
#include "gvd/observer.hpp"

namespace gvd::app {

/// What an operation tells, for the console and the report of a run: bars, notes with the options as the user wrote
/// them, and the time of each step. It is reported when the step ends, and in
/// all when this ends, where the step began again.
class RunObserver : public Observer {
 public:
  /// `run` must outlive it.
  explicit RunObserver(Run& run);
  ~RunObserver() override;
  RunObserver(const RunObserver&) = delete;
  RunObserver& operator=(const RunObserver&) = delete;

  bool progress(std::string_view step, double fraction) override;
  void enter(std::string_view step) override;
  void leave() override;
  void note(const std::string& text) override;
  void detail(const std::string& text) override;
  void status(const std::string& text) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Timed {
    std::string step;
    Clock::duration sum{};
    Clock::time_point started{};
    int times = 0;  ///< that it ended
  };
  void report(const Timed& timed);

  Run& run_;
  std::vector<Timed> steps_;          // in the order of their first starts
  std::vector<std::size_t> entered_;  // of `steps_`
};

}  // namespace gvd::app
