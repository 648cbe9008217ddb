// The file of --config: which options it gives, of which types, and what it refuses.

#include <algorithm>
#include <sstream>
#include <string>

#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/config_file.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_config_file {

using namespace app;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using gvd::test::parse_options;
using Texts = std::vector<std::string>;

std::string keep(const std::string&) { return ""; }

/// A command with an option of each kind, whose file is called f.
struct Fixture {
  Fixture() {
    line.set_help_flag("--help")->configurable(false);
    line.add_option("INPUT", input)->type_name("");
    add_parsed(line, "-n,--count", "N", keep, "");
    add_parsed(line, "--radius", "NUMBER", keep, "")->excludes("--count");
    add_parsed(line, "--vertices", "LIST", keep, "")->expected(1, 100)->excludes("--count");
    add_parsed(line, "--input-format", "TEXT", keep, "");
    add_parsed(line, "--max-memory", "SIZE", keep, "");
    add_parsed(line, "--view", "FILE", keep, "")->excludes("--input-format");
    add_parsed(line, "--up", "AXIS", keep, "")->needs("--view");
    add_flag(line, "--cut", cut, "");
    line.set_config("--config")->add_result("f");
  }

  std::vector<CLI::ConfigItem> read(const std::string& toml) {
    std::istringstream stream(toml);
    return ConfigFile(line).from_config(stream);
  }

  /// What is left of the file beside an option of the command line.
  Texts left(const std::string& name, const std::string& value, const std::string& toml) {
    line.get_option(name)->add_result(value);
    Texts names;
    for (const CLI::ConfigItem& item : read(toml)) names.push_back(item.name);
    line.get_option(name)->clear();
    return names;
  }

  CLI::App line{"A test.", "gvd-test"};
  Texts input;
  bool cut = false;
};

std::vector<CLI::ConfigItem> read(const std::string& toml) { return Fixture().read(toml); }

Texts values(const std::string& toml) { return read(toml).at(0).inputs; }

std::string refusal(const std::string& toml) {
  return test::refusal([&] { read(toml); });
}

TEST_CASE("entries have names and texts, in the order of the file") {
  const auto items = read("n = 12 # a comment\nradius = 0.1\n\n  cut = true\ninput-format = 'a\\b'\n");
  REQUIRE(items.size() == 4);
  const auto check = [&](std::size_t i, const std::string& name, const std::string& text) {
    CAPTURE(name);
    CHECK(items[i].name == name);
    CHECK(items[i].inputs == Texts{text});
  };
  check(0, "count", "12");
  check(1, "radius", "0.1");
  check(2, "cut", "true");
  check(3, "input-format", "a\\b");
  CHECK(refusal("radius = 0.1\n  cut = 1") == "f:2:9: cut: expected true or false, found a whole number");
  CHECK(refusal("input = ['x', 3]") ==
        "f:1:15: input: expected a string, or an array of strings, found a whole number");
  CHECK(read("").empty());
}

TEST_CASE("a key is any name of an option without its dashes") {
  CHECK(read("n = 3").at(0).name == "count");
  CHECK(values("count = 3") == Texts{"3"});
  CHECK(read("input = '-'").at(0).name == "INPUT");
  CHECK(read("input-format = 'off'").at(0).name == "input-format");
  for (const char* wrong :
       {"INPUT = 'a'", "input_format = 'off'", "-n = 3", "\"--count\" = 3", "N = 3", "help = true", "config = 'a'"}) {
    CHECK_THAT(refusal(wrong), StartsWith("f:1:1: ") && Contains("is not an option"));
  }
}

TEST_CASE("each option takes values of its type only") {
  CHECK(values("radius = 3") == Texts{"3"});
  CHECK(values("radius = 1e-300") == Texts{"1e-300"});
  CHECK(values("vertices = '3,17'") == Texts{"3,17"});
  CHECK(values("vertices = 3") == Texts{"3"});
  CHECK(values("vertices = [3, 17]") == Texts{"3", "17"});
  CHECK(values("max-memory = '2G'") == Texts{"2G"});
  CHECK(values("max-memory = 1000000000") == Texts{"1000000000"});
  CHECK(values("cut = false") == Texts{"false"});
  CHECK(values("input = ['a', 'b']") == Texts{"a", "b"});
  for (const char* wrong : {"n = 3.0", "n = '3'", "n = [3]", "n = true", "radius = '1'", "vertices = 1.5",
                            "vertices = []", "vertices = [[1]]", "input = 3", "input-format = ['a']", "cut = 1",
                            "cut = 'true'", "cut.a = 1", "max-memory = true", "view = 2020-01-01"}) {
    CAPTURE(wrong);
    CHECK_THAT(refusal(wrong), StartsWith("f:1:") && Contains(": expected ") && Contains(", found a"));
  }
}

TEST_CASE("a table is not an option, and two keys of one option are refused") {
  CHECK(refusal("[options]\nn = 3") == "f:1:2: options: is a table; write its keys outside of tables");
  CHECK(refusal("count = 3\nradius = 1\nn = 3") == "f:3:1: n: is the same option as count above");
}

TEST_CASE("the line overrides the same option, what it excludes, and what needs that") {
  Fixture fixture;
  const std::string file = "n = 3\ninput-format = 'a'\ncut = true\n";
  CHECK(fixture.left("--count", "9", file) == Texts{"input-format", "cut"});
  CHECK(fixture.left("--radius", "9", file) == Texts{"input-format", "cut"});
  CHECK(fixture.left("--cut", "false", file) == Texts{"count", "input-format"});
  CHECK(fixture.left("--view", "a", file) == Texts{"count", "cut"});
  CHECK(fixture.left("--input-format", "off", "view = 'a'\nup = 'x'\n").empty());
  CHECK(fixture.left("--input-format", "off", "up = 'x'\n").empty());
  CHECK(fixture.left("--view", "a", "up = 'x'\n") == Texts{"up"});
}

TEST_CASE("a value of the line overrides what does nothing beside it") {
  const test::ScratchFolder scratch;
  const std::string path = scratch / "o.toml";
  const auto computed = [&](const std::string& toml, Texts arguments) {
    test::write_text(path, toml);
    arguments.insert(arguments.end(), {"a.obj", "-n", "3", "--config", path});
    return parse_options(arguments).compute;
  };
  const std::string fast = "method = \"gbgvd\"\nfront = \"planar\"\n";
  CHECK(computed(fast, {"--method", "exact"}).front == std::nullopt);
  CHECK(computed(fast, {"--method", "paper"}).front == Front::planar);
  CHECK(computed(fast, {"--chord-tolerance", "1"}).method == Method::exact);
  CHECK(computed(fast, {"--chord-tolerance", "1"}).front == std::nullopt);
  CHECK(computed("chord-tolerance = 1\n", {"--method", "gbgvd"}).chord_tolerance == std::nullopt);
  CHECK_THROWS_WITH(computed("front = \"planar\"\n", {}), Contains("o.toml:1:1: --front does nothing here: add"));
  CHECK_THROWS_WITH(computed("method = \"paper\"\nchord-tolerance = 1\n", {}),
                    Contains("o.toml:1:1: --method paper and --chord-tolerance exclude each other"));
}

TEST_CASE("what is no TOML is refused with its place") {
  for (const char* wrong : {"n = [ 12\n", "n = \n", "n 12\n", "n = 12 13\n", "n = 'a\n", "n = 1\nn = 2\n", "= 3\n",
                            "n = 01\n", "n = 99999999999999999999\n", "n = \"\xff\"\n", "[a\n"}) {
    CAPTURE(wrong);
    CHECK_THAT(refusal(wrong), StartsWith("f:") && Contains(": not valid TOML: "));
  }
  CHECK_THAT(refusal("n = 1\nn = 2\n"), StartsWith("f:2:") && Contains("'n'"));
  CHECK_THAT(refusal("a = 1\n  n = [ 12\n"), StartsWith("f:2:") && Contains(": n: not valid TOML: "));
  CHECK_THAT(refusal("n 12\n"), StartsWith("f:1:") && !Contains("n: "));
}

// The parser's own assertions used to end a build that has assertions.
TEST_CASE("a table's name that begins with a zero byte is refused") {
  CHECK_THAT(refusal(std::string("[\0\t\x1f'", 5)), StartsWith("f:1:2: ") && Contains("not valid TOML: "));
}

// The parser took letters like these for unreachable, in keys and beside line breaks in strings.
TEST_CASE("letters that are not ASCII are refused outside of strings and kept inside") {
  for (const char* letter : {"\u00a1", "\u00e4", "\u0283", "\u0499"}) {
    const std::string text = letter;
    CHECK_THAT(refusal(text + " = 1\n"), StartsWith("f:1:") && Contains("not valid TOML: "));
    CHECK_THAT(refusal("n = " + text + "\n"), StartsWith("f:1:") && Contains("not valid TOML: "));
    CHECK(values("input = \"\"\"\\\n" + text + "\"\"\"\n").at(0).ends_with(text));
  }
}

TEST_CASE("a message about a key or about what is no TOML is printable and short") {
  CHECK_THAT(refusal("\"a\\nb\" = 1"), Contains(": a b: is not an option"));
  CHECK_THAT(refusal("\"" + std::string(500, 'x') + "\" = 1"), Contains("xxx...: is not an option"));
  for (const std::string& wrong : {std::string("\1\0\t'a' = 1\nn = 99999999999999999999\n", 36),
                                   std::string(5000, 'k') + " = [", std::string("n = \"\x1b[2J")}) {
    const std::string message = refusal(wrong);
    CHECK(message.size() < 300);
    CHECK(std::none_of(message.begin(), message.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }));
  }
}

TEST_CASE("a file in UTF-16 is refused with what to do") {
  const std::string little(
      "n\0 \0=\0 \0"
      "3\0",
      10),
      big("\0n\0 \0=\0 \0"
          "3",
          10);
  for (const std::string& text : {"\xff\xfe" + little, "\xfe\xff" + big, little, big}) {
    CHECK(refusal(text) == "f: the file is text in UTF-16; save it as UTF-8");
  }
  CHECK(values("\xef\xbb\xbfinput = 'a'\n") == Texts{"a"});
}

TEST_CASE("a file that can't be read is refused by its name") {
  const test::ScratchFolder scratch;
  const auto with = [](const std::string& file) { return parse_options({"a.obj", "--config", file}); };
  CHECK_THROWS_WITH(with(scratch / "none.toml"), Contains("none.toml"));
  CHECK_THROWS_WITH(with(scratch / ""), Contains("is actually a directory"));
  test::write_text(scratch / "a.toml", "n = 3\n");
  CHECK(with(scratch / "a.toml").generators.count == 3);
  CHECK(with(scratch / "a.toml").config == scratch / "a.toml");
}

}  // namespace gvd::test_config_file
