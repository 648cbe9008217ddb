#pragma once

#include "gvd/vec.hpp"

namespace gvd {

/// A search for the value of least rank: the first one offered of those with the same rank. Ranks are compared by `<`.
template <class Value, class Rank = double>
struct Least {
  Value value{};  ///< the default value as long as no offer has had a rank below the first one
  Rank rank = kInfinity;

  /// Takes the value if its rank is below the least so far.
  void offer(const Rank& offered_rank, const Value& offered) {
    if (!(offered_rank < rank)) return;
    rank = offered_rank;
    value = offered;
  }
};

}  // namespace gvd
