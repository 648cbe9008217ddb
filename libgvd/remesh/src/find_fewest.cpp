// The search for the smallest number whose error is at most a target.
//
// Each trial costs a whole remesh, so the search predicts: errors fall about as 1 / number, and the next trial is the
// number that meets the target by this rule. Growth and shrinkage are bounded, because the rule may be wrong. As soon
// as a number that is too small and one that is enough are known, trials bisect between them by the geometric mean.

#include "gvd/find_fewest.hpp"

#include <algorithm>
#include <cmath>

#include "gvd/error.hpp"

namespace gvd {
namespace {

/// The largest and the smallest factor from one number to the next, as long as all numbers are too small or all are
/// enough.
constexpr double kMostGrowth = 8, kLeastGrowth = 1.25;

/// The numbers that are known to be too small and to be enough.
struct Bracket {
  std::int32_t too_small = 0;
  std::optional<std::int32_t> enough;

  void add(const CountTrial& trial, double target) {
    if (trial.error <= target) {
      enough = trial.count;
    } else {
      too_small = trial.count;
    }
  }
  bool is_closed(double tolerance) const { return enough && *enough - too_small <= std::max(1.0, tolerance * *enough); }
};

std::int32_t next_count(const CountTrial& last, const Bracket& bracket, const FewestOptions& options) {
  const double factor = std::isfinite(last.error) ? last.error / options.target : kMostGrowth;
  const double count = last.count, predicted = std::round(count * factor);
  double next = 0;
  if (!bracket.enough) {
    next = std::clamp(predicted, std::ceil(count * kLeastGrowth), count * kMostGrowth);
  } else if (bracket.too_small > 0) {
    next = std::round(std::sqrt(double(bracket.too_small) * *bracket.enough));
  } else {
    next = std::clamp(predicted, std::floor(count / kMostGrowth), std::floor(count / kLeastGrowth));
  }
  const double most = bracket.enough ? *bracket.enough - 1 : options.most;
  return static_cast<std::int32_t>(std::clamp(next, bracket.too_small + 1.0, std::max(most, bracket.too_small + 1.0)));
}

}  // namespace

Fewest find_fewest(const FewestOptions& options, const std::function<double(std::int32_t)>& error_of) {
  const bool has_range = options.first >= 1 && options.first <= options.most && options.max_trials >= 1;
  if (!has_range || !(options.target > 0)) {
    throw Error(ErrorCode::invalid_option, "the search for a number needs a target above 0, and a range of numbers");
  }
  if (!(options.tolerance >= 0)) throw Error(ErrorCode::invalid_option, "the tolerance must not be negative");
  Fewest result;
  Bracket bracket;
  std::int32_t count = options.first;
  while (std::ssize(result.trials) < options.max_trials) {
    result.trials.push_back({count, error_of(count)});
    bracket.add(result.trials.back(), options.target);
    if (bracket.is_closed(options.tolerance) || bracket.too_small >= options.most) break;
    count = next_count(result.trials.back(), bracket, options);
  }
  result.count = bracket.enough;
  return result;
}

}  // namespace gvd
