#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gvd::app {

/// How long a step still takes, from the time that its first part took.
class TimeLeft {
 public:
  /// Seconds, or nothing while too little is known: in the first second, and before a hundredth of the step is done.
  /// `now`: seconds, from any start. A step of another name, or one that begins again, is measured anew.
  std::optional<double> update(std::string_view step, double fraction, double now);

 private:
  std::string step_;
  double first_fraction_ = 0, last_fraction_ = 0, started_ = 0;
};

/// "12 s left", "3 min left" or "2 h left".
std::string format_time_left(double seconds);

}  // namespace gvd::app
