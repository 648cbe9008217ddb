// Sums without rounding.
#include "intersection/expansion.hpp"
#include "support/catch.hpp"

namespace gvd::test_expansion {

TEST_CASE("an expansion keeps what a double rounds off") {
  Expansion sum;
  CHECK(sum.sign() == 0);
  for (const double value : {1e100, 1.0, -1e100}) sum.add(value);
  CHECK(sum.sign() == 1);
  sum.add(-1 - 1e-16);
  CHECK(sum.sign() == 0);  // -1 - 1e-16 is rounded to -1 before the call
  sum.add(-1e-300);
  CHECK(sum.sign() == -1);
}

TEST_CASE("products of differences are exact") {
  const auto tiny = exact_difference(1, 1e-30);
  CHECK(tiny[0] == 1);
  CHECK(tiny[1] == -1e-30);
  Expansion square, cube;
  square.add_product(tiny, tiny);
  square.add(-1);
  CHECK(square.sign() == -1);
  square.add_product({2, 0}, {1e-30, 0});
  CHECK(square.sign() == 1);  // (1 - x)^2 = 1 - 2 x + x^2
  cube.add_product(tiny, tiny, tiny);
  cube.add_product(negated(tiny), tiny, tiny);
  CHECK(cube.sign() == 0);
}

}  // namespace gvd::test_expansion
