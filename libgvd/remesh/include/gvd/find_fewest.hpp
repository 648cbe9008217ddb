#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace gvd {

struct FewestOptions {
  double target = 0;            ///< largest error that is allowed, > 0
  std::int32_t first = 100;     ///< the first number to try, in [1, most]
  std::int32_t most = 1000000;  ///< the largest number to try, >= first
  int max_trials = 16;          ///< >= 1
  /// The search ends once a number that is too small is within this fraction of one that is enough, >= 0.
  double tolerance = 0.02;
};

struct CountTrial {
  std::int32_t count = 0;
  double error = 0;  ///< infinite if the number gives no result
};

struct Fewest {
  std::optional<std::int32_t> count;  ///< the smallest number tried that is enough; nothing if none is
  std::vector<CountTrial> trials;     ///< in the order in which they were made
};

/// Searches for the smallest number whose error is at most the target, if errors fall about as 1 / number. The error of
/// a remesh does, because its distance from the surface falls with the square of its edge length.
///
/// Each trial uses the number that this rule predicts from the trial before. Once one number is too small and another
/// one is enough, trials bisect between the two by their geometric mean.
///
/// Properties: (1) if `count` is set, its error is at most the target; (2) no number that was tried and is smaller is
/// enough; a smaller one that was not tried may be, because errors need not fall everywhere; (3) deterministic if
/// `error_of` is.
/// Throws what `error_of` throws, and Error{invalid_option} for an option out of its range. Cost: at most `max_trials`
/// calls of `error_of`.
Fewest find_fewest(const FewestOptions& options, const std::function<double(std::int32_t)>& error_of);

}  // namespace gvd
