#include "gvd/error.hpp"
#include "mesh/reading/check_counts.hpp"
#include "support/catch.hpp"

namespace gvd::test_check_counts {

TEST_CASE("check_counts: as many vertices and polygons as 32-bit ids can count, and not one more") {
  const auto most = static_cast<std::uint64_t>(kMostVertices);
  CHECK_NOTHROW(check_counts(most, most, "file"));
  CHECK_THROWS_AS(check_counts(most + 1, 0, "file"), Error);
  CHECK_THROWS_AS(check_counts(0, most + 1, "file"), Error);
}

}  // namespace gvd::test_check_counts
