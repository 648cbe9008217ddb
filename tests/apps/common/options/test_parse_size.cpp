#include "common/options/parse_size.hpp"
#include "support/catch.hpp"

namespace gvd::test_parse_size {

using Catch::Matchers::Contains;
using gvd::app::parse_size;

TEST_CASE("sizes have binary units, in any spelling") {
  CHECK(parse_size("1").bytes == 1);
  CHECK(parse_size("500K").bytes == 500 * 1024);
  CHECK(parse_size("500m").bytes == 500LL << 20);
  CHECK(parse_size("2G").bytes == 2LL << 30);
  CHECK(parse_size("1.5GiB").bytes == 3LL << 29);
  CHECK(parse_size("3TB").bytes == 3LL << 40);
  CHECK(parse_size("7b").bytes == 7);
}

TEST_CASE("what is no size is refused") {
  for (const char* text : {"", "G", "B", "1X", "1 G", "1GG", "1i", "nan", "inf", "G1", "1e", "infK"}) {
    CAPTURE(text);
    CHECK_THAT(parse_size(text).wrong, Contains("is no size; write a number with K, M, G or T, as 500M or 2G"));
  }
}

TEST_CASE("sizes that no memory has are told as such") {
  for (const char* text : {"1e30", "1e999", "1048577T", "99999999999999999999"}) {
    CAPTURE(text);
    CHECK_THAT(parse_size(text).wrong, Contains("is too large; write at most 1048576T"));
  }
  for (const char* text : {"0", "0.2", "-1G", "1e-999"}) {
    CAPTURE(text);
    CHECK_THAT(parse_size(text).wrong, Contains("is less than a byte"));
  }
  CHECK(parse_size("1048576T").bytes == std::int64_t{1} << 60);
}

}  // namespace gvd::test_parse_size
