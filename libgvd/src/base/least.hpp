#pragma once

#include "gvd/vec.hpp"

namespace gvd {

/// Keeps the value of least rank among all that are offered, and of equal ranks the first. Ranks are compared by `<`.
template <class Value, class Rank = double>
struct Least {
  Value value{};  ///< the default value until an offer has a rank below the initial `rank`
  Rank rank = kInfinity;

  /// Takes the value if its rank is below the least so far.
  void offer(const Rank& offered_rank, const Value& offered) {
    if (!(offered_rank < rank)) return;
    rank = offered_rank;
    value = offered;
  }
};

}  // namespace gvd
