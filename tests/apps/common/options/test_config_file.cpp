#include <algorithm>
#include <string>

#include "apps/run_command.hpp"
#include "common/options/config_file.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_config_file {

using namespace app;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

std::string refusal(const std::string& content) {
  return test::refusal([&] { parse_config(content, "a.toml"); });
}

TEST_CASE("entries have type, text and place, in the order of the file") {
  using Type = ConfigValue::Type;
  const auto entries =
      parse_config("z = 12 # a comment\na = 0.1\n\n  on = true\ntext = 'a\\b'\nday = 2020-01-01\n", "f");
  REQUIRE(entries.size() == 5);
  const auto check = [&](std::size_t i, const std::string& key, Type type, const std::string& text) {
    CAPTURE(key);
    CHECK(entries[i].key == key);
    CHECK(!entries[i].is_array);
    REQUIRE(entries[i].values.size() == 1);
    CHECK(entries[i].values[0].type == type);
    CHECK(entries[i].values[0].text == text);
  };
  check(0, "z", Type::whole, "12");
  check(1, "a", Type::number, "0.1");
  check(2, "on", Type::flag, "true");
  check(3, "text", Type::text, "a\\b");
  check(4, "day", Type::other, "");
  CHECK(entries[2].place == "f:4:3");
  CHECK(entries[2].values[0].place == "f:4:8");
}

TEST_CASE("an array gives its values, a table one of no type") {
  const auto entries = parse_config("a = [1, \"x\"]\ne = []\n[t]\nb = 1\n", "f");
  REQUIRE(entries.size() == 3);
  CHECK(entries[0].is_array);
  REQUIRE(entries[0].values.size() == 2);
  CHECK(entries[0].values[1].text == "x");
  CHECK(entries[0].values[1].place == "f:1:9");
  CHECK(entries[1].values.empty());
  CHECK(entries[2].values.at(0).type_name == "a table");
}

TEST_CASE("what is no TOML is refused with its place") {
  for (const char* wrong : {"n = [ 12\n", "n = \n", "n 12\n", "n = 12 13\n", "n = 'a\n", "n = 1\nn = 2\n", "= 3\n",
                            "n = 01\n", "n = 99999999999999999999\n", "n = \"\xff\"\n", "[a\n"}) {
    CAPTURE(wrong);
    CHECK_THAT(refusal(wrong), StartsWith("a.toml:") && Contains(": no TOML: "));
  }
  CHECK_THAT(refusal("n = 1\nn = 2\n"), StartsWith("a.toml:2:") && Contains("'n'"));
  CHECK_THAT(refusal("a = 1\n  n = [ 12\n"), StartsWith("a.toml:2:") && Contains(": n: no TOML: "));
  CHECK_THAT(refusal("n 12\n"), StartsWith("a.toml:1:") && !Contains("n: "));
  CHECK(parse_config("", "f").empty());
}

// The parser's own assertions used to end a build that has assertions.
TEST_CASE("a table's name that begins with a zero byte is refused") {
  CHECK_THAT(refusal(std::string("[\0\t\x1f'", 5)), StartsWith("a.toml:1:2: ") && Contains("no TOML: "));
}

// The parser took letters like these for unreachable, in keys and beside line breaks in strings.
TEST_CASE("letters that are not ASCII are refused outside of strings and kept inside") {
  for (const char* letter : {"\u00a1", "\u00e4", "\u0283", "\u0499"}) {
    const std::string text = letter;
    CHECK_THAT(refusal(text + " = 1\n"), StartsWith("a.toml:1:") && Contains("no TOML: "));
    CHECK_THAT(refusal("n = " + text + "\n"), StartsWith("a.toml:1:") && Contains("no TOML: "));
    CHECK(parse_config("input = \"\"\"\\\n" + text + "\"\"\"\n", "f").at(0).values.at(0).text.ends_with(text));
  }
}

TEST_CASE("a message about what is no TOML is printable and short") {
  for (const std::string& wrong : {std::string("\1\0\t'a' = 1\nn = 99999999999999999999\n", 36),
                                   std::string(5000, 'k') + " = [", std::string("n = \"\x1b[2J")}) {
    const std::string message = refusal(wrong);
    CHECK(message.size() < 300);
    CHECK(std::none_of(message.begin(), message.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }));
  }
}

TEST_CASE("a file that can't be read is refused by its name") {
  const test::ScratchFolder scratch;
  CHECK_THROWS_WITH(read_config_file(scratch / "none.toml"), Contains("none.toml"));
  CHECK_THROWS_WITH(read_config_file(scratch / ""), Contains("is a directory"));
  test::write_text(scratch / "a.toml", "n = 3\n");
  CHECK(read_config_file(scratch / "a.toml").at(0).place == scratch / "a.toml:1:1");
}

}  // namespace gvd::test_config_file
