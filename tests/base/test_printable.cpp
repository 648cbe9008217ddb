#include "base/printable.hpp"
#include "support/catch.hpp"

namespace gvd::test_printable {

using namespace test;

TEST_CASE("texts from files are printable and short in messages") {
  CHECK(printable("abc") == "abc");
  CHECK(printable("a\tb\xff") == "a?b?");
  CHECK(printable("abcdef", 3) == "abc...");
  CHECK(printable("") == "");
}

TEST_CASE("a quotation is short and printable") {
  CHECK(gvd::quoted("abc") == "'abc'");
  CHECK(gvd::quoted("a\n\x01\xff") == "'a" + std::string(3, '?') + "'");
  CHECK(gvd::quoted(std::string(100, 'x')) == "'" + std::string(kLongestQuote, 'x') + "...'");
}

}  // namespace gvd::test_printable
