#include "common/options/parse_size.hpp"
#include "support/catch.hpp"

using gvd::app::parse_size;

TEST_CASE("sizes have binary units, in any spelling") {
  CHECK(parse_size("1") == 1);
  CHECK(parse_size("500K") == 500 * 1024);
  CHECK(parse_size("500m") == 500LL << 20);
  CHECK(parse_size("2G") == 2LL << 30);
  CHECK(parse_size("1.5GiB") == 3LL << 29);
  CHECK(parse_size("3TB") == 3LL << 40);
  CHECK(parse_size("7b") == 7);
}

TEST_CASE("what is no size is refused") {
  for (const char* text : {"", "G", "B", "-1G", "0", "0.2", "1X", "1 G", "1GG", "1i", "nan", "inf", "1e30", "G1"}) {
    CAPTURE(text);
    CHECK(!parse_size(text));
  }
}
