#include "common/run/time_left.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gvd::app {
namespace {

constexpr double kLeastSeconds = 1;
constexpr double kLeastShare = 0.01;
/// A step whose fraction falls by more has begun again; by less, some of its work was in vain.
constexpr double kFall = 0.1;

}  // namespace

std::optional<double> TimeLeft::update(std::string_view step, double fraction, double now) {
  if (step != step_ || fraction < last_fraction_ - kFall) {
    step_ = step;
    first_fraction_ = last_fraction_ = fraction;
    started_ = now;
  }
  last_fraction_ = std::max(last_fraction_, fraction);
  const double share = last_fraction_ - first_fraction_, taken = now - started_;
  if (taken < kLeastSeconds || share < kLeastShare) return std::nullopt;
  return taken * (1 - last_fraction_) / share;
}

std::string format_time_left(double seconds) {
  constexpr double kMinute = 60, kHour = 3600, kMost = 999;
  if (seconds < kMinute) return fmt::format("{:.0f} s left", std::ceil(seconds));
  if (seconds < kHour) return fmt::format("{:.0f} min left", std::ceil(seconds / kMinute));
  return fmt::format("{:.0f} h left", std::min(kMost, std::ceil(seconds / kHour)));
}

}  // namespace gvd::app
