#include "gvd/counted.hpp"
#include "support/catch.hpp"

namespace gvd::test_counted {

TEST_CASE("counted: singular for one only") {
  CHECK(counted(0, "face", "faces") == "0 faces");
  CHECK(counted(1, "face", "faces") == "1 face");
  CHECK(counted(2'000'000'000'000, "face", "faces") == "2000000000000 faces");
}

}  // namespace gvd::test_counted
