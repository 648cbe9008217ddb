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
  /// The search ends where a number that is too small is within this fraction below one that is enough, >= 0.
  double tolerance = 0.02;
};

struct CountTrial {
  std::int32_t count = 0;
  double error = 0;  ///< infinite where a number gives nothing
};

struct Fewest {
  std::optional<std::int32_t> count;  ///< the smallest that was tried and is enough; nothing if none is
  std::vector<CountTrial> trials;     ///< in their order
};

/// Searches for the smallest number whose error is at most the target, where errors fall about as 1 / number. That of a
/// remesh does: its distance from its surface falls with the square of its edges' length.
///
/// A trial takes the number that this rule predicts from the last one. Once a number is too small and another one is
/// enough, trials bisect between them, by the geometric mean. Errors need not fall everywhere: a smaller number may
/// then be enough, too. Deterministic if `error_of` is. Throws what `error_of` throws, and Error{invalid_option} for an
/// option out of its range. Cost: `max_trials` calls of `error_of` at most.
Fewest find_fewest(const FewestOptions& options, const std::function<double(std::int32_t)>& error_of);

}  // namespace gvd
