// Plain lists of numbers, as densities are given.
#include "gvd/text.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_read_numbers {

using namespace test;

std::string refused(const std::string& content) {
  return refusal([&] { parse_numbers(content, "list"); }, ErrorCode::unreadable_input);
}

TEST_CASE("numbers stand between blanks, commas and line ends, and # begins a comment") {
  CHECK(parse_numbers("\xef\xbb\xbf# weights\n1 2.5,\t-3e2 , 4 # 5\r\n\n6", "list") ==
        std::vector<double>{1, 2.5, -300, 4, 6});
  CHECK(parse_numbers("", "list").empty());
  CHECK(parse_numbers(" ,\n, ,\n", "list").empty());
}

TEST_CASE("what is no number in full is refused with its line") {
  CHECK(refused("1\n2 two 3\n") == "list:2: 'two' is no number");
  CHECK(refused("1\n\n2.5x") == "list:3: '2.5x' is no number");
  CHECK(refused("1;2") == "list:1: '1;2' is no number");
  CHECK(refused("1e999") == "list:1: '1e999' is no number");
}

TEST_CASE("a file of numbers that is not there is refused with its name") {
  const std::string message = refusal([] { read_numbers("missing/numbers.txt"); }, ErrorCode::unreadable_input);
  CHECK(message == "missing/numbers.txt: No such file or directory; name a list of numbers");
  CHECK(refusal([] { read_numbers("/"); }, ErrorCode::unreadable_input) == "/: is a directory; name a list of numbers");
}

}  // namespace gvd::test_read_numbers
