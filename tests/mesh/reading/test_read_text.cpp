#include <cmath>
#include <limits>
#include <string>

#include "gvd/error.hpp"
#include "mesh/reading/readers.hpp"
#include "support/catch.hpp"

namespace gvd::test_read_text {

template <class Work>
std::string message_of(Work work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_CASE("parse_double: signs, exponents, values out of range, and what is no number") {
  CHECK(parse_double("1") == 1);
  CHECK(parse_double("+1.5") == 1.5);
  CHECK(parse_double("-2e-3") == -0.002);
  CHECK(parse_double("0.1") == 0.1);
  CHECK(parse_double("1e999") == std::numeric_limits<double>::infinity());
  CHECK(parse_double("-1e999") == -std::numeric_limits<double>::infinity());
  CHECK(parse_double("1e-999") == 0);
  CHECK(std::signbit(*parse_double("-1e-999")));
  CHECK(parse_double("0.0001e-99999999999999999999") == 0);
  CHECK(parse_double("10000e99999999999999999999") == std::numeric_limits<double>::infinity());
  CHECK(std::isnan(*parse_double("nan")));
  for (const char* text : {"", "+", "-", "x", "1x", "1,5", "+-1", "++1", " 1", "0x10"}) {
    INFO(text);
    CHECK_FALSE(parse_double(text));
  }
}

TEST_CASE("parse_integer: signs, and nothing beyond 64 bits") {
  CHECK(parse_integer("-12") == -12);
  CHECK(parse_integer("+7") == 7);
  CHECK(parse_integer("9223372036854775807") == std::numeric_limits<std::int64_t>::max());
  for (const char* text : {"", "9223372036854775808", "1.0", "1e3", "+-1", "a"}) CHECK_FALSE(parse_integer(text));
}

TEST_CASE("text reader: lines end in LF, CR LF or CR, and are numbered") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string bytes = "a b" + end + end + "c" + end;
    TextReader text(bytes, "file", false);
    REQUIRE(text.next_line());
    CHECK(text.token() == "a");
    CHECK(text.token() == "b");
    CHECK(text.token().empty());
    REQUIRE(text.next_content_line());
    CHECK(text.token() == "c");
    CHECK(text.line_number() == 3);
    CHECK_FALSE(text.next_content_line());
  }
}

TEST_CASE("text reader: a byte order mark is skipped, comments only where they are wanted") {
  TextReader with("\xEF\xBB\xBF# all\nv 1#2\n", "file", true);
  REQUIRE(with.next_content_line());
  CHECK(with.token() == "v");
  CHECK(with.token() == "1");
  CHECK(with.token().empty());
  TextReader without("v 1#2\n", "file", false);
  REQUIRE(without.next_line());
  CHECK(without.token() == "v");
  CHECK(without.token() == "1#2");
}

TEST_CASE("text reader: an element may continue on the next lines, and must end with its line") {
  TextReader text("1 2\n3\n4 5 6 7\n8 9\n\n1 2 3\n", "file", false);
  REQUIRE(text.begin_element());
  CHECK(text.position(0) == Vec3(1, 2, 3));
  CHECK_NOTHROW(text.end_element("vertex", 0));
  REQUIRE(text.begin_element());
  CHECK(text.position(1) == Vec3(4, 5, 6));
  CHECK_NOTHROW(text.end_element("vertex", 1));  // on one line, what follows is the caller's business
  REQUIRE(text.begin_element());
  CHECK(text.position(2) == Vec3(8, 9, 1));
  CHECK_THAT(message_of([&] { text.end_element("vertex", 2); }), Catch::Matchers::Contains("file:4: vertex 2"));
}

TEST_CASE("text reader: messages name the file, the line and the token") {
  TextReader text("1 x nan\n", "file", false);
  REQUIRE(text.next_line());
  CHECK(text.number("a count") == 1);
  CHECK_THAT(message_of([&] { text.integer("a count"); }), Catch::Matchers::Contains("file:1: a count is 'x'"));
  CHECK_THAT(message_of([&] { text.position(4); }), Catch::Matchers::Contains("vertex 4"));
  CHECK_THAT(message_of([&] { text.number("a count"); }), Catch::Matchers::Contains("a count is missing"));
}

}  // namespace gvd::test_read_text
