// The length of a step after one that was too long.
#include <limits>

#include "optimiser/line_search.hpp"
#include "support/catch.hpp"

namespace gvd::test_line_search {

TEST_CASE("line search: the lowest point of a parabola is found") {
  // f(t) = -2 t + 4 t^2 is lowest at 1/4.
  CHECK(shorter_scale(1, -2, 2) == Approx(0.25));
  CHECK(shorter_scale(0.8, -2, -1.6 + 2.56) == Approx(0.25));
}

TEST_CASE("line search: every scale is a tenth to a half of the one before") {
  for (const double rise : {-0.5, 0.0, 1e-9, 1.0, 1e9, std::numeric_limits<double>::infinity()}) {
    const double scale = shorter_scale(0.3, -2, rise);
    CHECK(scale >= 0.03);
    CHECK(scale <= 0.15);
  }
}

}  // namespace gvd::test_line_search
