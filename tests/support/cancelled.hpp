#pragma once

#include <map>
#include <set>
#include <string>

#include "gvd/error.hpp"
#include "gvd/progress.hpp"
#include "support/catch.hpp"

namespace gvd::test {

/// Calls run(progress) to its end, and then once for each of many calls of `progress`, which is the one that cancels:
/// the first call of each step, the last one, and those between in even steps. Each must throw Error{interrupted}, and
/// call no more. Returns the number of calls of each step. The calls must be the same each time: one thread.
template <class Run>
std::map<std::string, int> require_cancelled_everywhere(const Run& run) {
  constexpr int kEven = 24;
  std::map<std::string, int> calls;
  std::set<int> stops;
  int count = 0;
  run(Progress([&](std::string_view step, double fraction) {
    REQUIRE((fraction >= 0 && fraction <= 1));
    if (++calls[std::string(step)] == 1) stops.insert(count);
    ++count;
    return true;
  }));
  REQUIRE(count > 0);
  for (int i = 1; i <= kEven; ++i) stops.insert((count - 1) * i / kEven);
  for (const int stop : stops) {
    INFO("cancelled at call " << stop << " of " << count);
    int made = 0;
    ErrorCode code{};
    try {
      run(Progress([&](std::string_view, double) { return made++ < stop; }));
    } catch (const Error& error) {
      code = error.code();
    }
    REQUIRE(code == ErrorCode::interrupted);
    REQUIRE(made == stop + 1);
  }
  return calls;
}

}  // namespace gvd::test
