#include "common/run/time_left.hpp"
#include "support/catch.hpp"

namespace gvd::test_time_left {

using namespace app;

TEST_CASE("the time left is that of the part that is left") {
  TimeLeft left;
  CHECK(!left.update("a", 0, 100));
  CHECK(!left.update("a", 0.2, 100.5));  // the first second
  CHECK(!left.update("b", 0, 101));      // another step
  CHECK(!left.update("b", 0.001, 109));  // less than a hundredth
  CHECK(left.update("b", 0.5, 111) == Approx(10));
  CHECK(left.update("b", 0.75, 113) == Approx(4));
}

TEST_CASE("a step may go back a little, and is measured anew where it begins again") {
  TimeLeft left;
  left.update("a", 0, 0);
  CHECK(left.update("a", 0.5, 10) == Approx(10));
  CHECK(left.update("a", 0.45, 12) == Approx(12));
  CHECK(!left.update("a", 0, 13));
  CHECK(left.update("a", 0.5, 15) == Approx(2));
}

TEST_CASE("the time left has a unit that suits it") {
  CHECK(format_time_left(0.2) == "1 s left");
  CHECK(format_time_left(59) == "59 s left");
  CHECK(format_time_left(61) == "2 min left");
  CHECK(format_time_left(7200) == "2 h left");
  CHECK(format_time_left(1e30) == "999 h left");
}

}  // namespace gvd::test_time_left
