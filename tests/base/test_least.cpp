// The value of least rank: the first of equals, none above the first rank, and ranks of several numbers.
#include <limits>
#include <string>
#include <utility>

#include "base/least.hpp"
#include "support/catch.hpp"

namespace gvd::test_least {

TEST_CASE("least: the first one of the least rank stays") {
  Least<int> least{-1};
  CHECK(least.value == -1);
  least.offer(2, 10);
  least.offer(1, 20);
  least.offer(1, 30);
  least.offer(std::numeric_limits<double>::quiet_NaN(), 40);
  CHECK(least.value == 20);
  CHECK(least.rank == 1);
}

TEST_CASE("least: offers of no less than the first rank are not taken") {
  Least<std::string> least{"none", 0};
  least.offer(0, "zero");
  CHECK(least.value == "none");
  least.offer(-1, "below");
  CHECK(least.value == "below");
}

TEST_CASE("least: ranks of two numbers are compared in order") {
  Least<char, std::pair<bool, double>> least{'-', {true, kInfinity}};
  least.offer({true, 1}, 'a');
  least.offer({false, 9}, 'b');
  least.offer({false, 8}, 'c');
  least.offer({true, 0}, 'd');
  CHECK(least.value == 'c');
}

}  // namespace gvd::test_least
