#pragma once

#include "diagram/graph/crossings.hpp"
#include "support/catch.hpp"

namespace gvd::test {

/// Requires the same crossings in the same order on each edge, with their gaps; only the parameters may differ.
inline void require_same_order(const Crossings& before, const Crossings& after) {
  REQUIRE(after.size() == before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Crossing &was = before.items()[i], &is = after.items()[i];
    REQUIRE((is.edge == was.edge && is.before == was.before && is.after == was.after));
    REQUIRE(is.t >= kCrossingGap * (1 - 1e-6));
    REQUIRE(is.t <= 1 - kCrossingGap * (1 - 1e-6));
    if (i > 0 && after.items()[i - 1].edge == is.edge)
      REQUIRE(is.t - after.items()[i - 1].t >= kCrossingGap * (1 - 1e-6));
  }
}

}  // namespace gvd::test
