#include "geodesic/windows/field/window_limit.hpp"
#include "support/catch.hpp"

namespace gvd::test_window_limit {

TEST_CASE("more windows than 32 bits can number are refused") {
  CHECK_NOTHROW(check_window_count(0, kMostWindows));
  CHECK_NOTHROW(check_window_count(kMostWindows - 1024, 1024));
  CHECK_THROWS_AS(check_window_count(kMostWindows - 1023, 1024), Error);
}

}  // namespace gvd::test_window_limit
