#include <clocale>

#include "common/options/parse_number.hpp"
#include "support/catch.hpp"

namespace gvd::test_parse_number {

using namespace app;

TEST_CASE("a number is the whole text, in any locale") {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(parse_number<double>("1.5") == 1.5);
  CHECK(parse_number<double>("-2e-3") == -2e-3);
  CHECK(!parse_number<double>("1,5"));
  std::setlocale(LC_ALL, "C");
  CHECK(parse_number<int>("010") == 10);
  for (const char* wrong : {"", " 1", "1 ", "+1", "1x", "0x10", "one", "99999999999"}) {
    CAPTURE(wrong);
    CHECK(!parse_number<int>(wrong));
  }
  CHECK(parse_number<std::uint64_t>("18446744073709551615") == 18446744073709551615u);
  CHECK(!parse_number<std::uint64_t>("-1"));
}

TEST_CASE("a range holds its ends, and no NaN") {
  CHECK(parse_number_in("1", kCount) == 1);
  CHECK(!parse_number_in("0", kCount));
  CHECK(parse_number_in("0", kNotNegative) == 0.0);
  CHECK(!parse_number_in("-0.1", kNotNegative));
  CHECK(!parse_number_in("0", kPositive));
  CHECK(parse_number_in("1e-300", kPositive) == 1e-300);
  for (const char* wrong : {"nan", "-nan", "inf", "1e999"}) CHECK(!parse_number_in(wrong, kNotNegative));
}

}  // namespace gvd::test_parse_number
