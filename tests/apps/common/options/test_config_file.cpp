// The file of --config: which options it gives, of which types, and what it refuses.

#include <algorithm>
#include <sstream>
#include <string>

#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/config_file.hpp"
#include "gvd/error.hpp"
#include "options/toy_options.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_config_file {

using namespace app;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using gvd::test::parse_options;
using Texts = std::vector<std::string>;

/// What a file gives, beside what a command line has.
struct Fixture : test::Toy {
  std::vector<GivenTexts> read(const std::string& toml) {
    std::istringstream stream(toml);
    return read_config_file(list, stream, "f");
  }

  /// The options of the file that an option of the command line leaves.
  Texts left(const std::string& name, const Texts& texts, const std::string& toml) {
    const std::vector<GivenTexts> typed{{list.find(name), {"--" + name, ""}, texts}};
    Texts names;
    for (const GivenTexts& given : read(toml)) {
      if (!is_overridden(list, *given.option, typed)) names.push_back(given.option->name);
    }
    return names;
  }
};

Texts values(const std::string& toml) { return Fixture().read(toml).at(0).texts; }

std::string refusal(const std::string& toml) {
  return test::refusal([&] { Fixture().read(toml); });
}

TEST_CASE("entries have names, texts and places, in the order of the file") {
  Fixture fixture;
  const auto entries = fixture.read("n = 12 # a comment\nradius = 0.1\n\n  cut = true\ndensity = 'a\\b'\n");
  REQUIRE(entries.size() == 4);
  const auto check = [&](std::size_t i, const std::string& name, const std::string& place, const std::string& text) {
    CAPTURE(name);
    CHECK(entries[i].option->name == name);
    CHECK(entries[i].source.place == place);
    CHECK(entries[i].texts == Texts{text});
  };
  check(0, "count", "f:1:1", "12");
  check(1, "radius", "f:2:1", "0.1");
  check(2, "cut", "f:4:3", "true");
  check(3, "density", "f:5:1", "a\\b");
  CHECK(entries[0].source.spelling == "n");
  CHECK(refusal("radius = 0.1\n  cut = 1") == "f:2:9: cut: expected true or false, found a whole number");
  CHECK(refusal("input = ['x', 3]") ==
        "f:1:15: input: expected a string, or an array of strings, found a whole number");
  CHECK(fixture.read("").empty());
}

TEST_CASE("a key is any name of an option without its dashes") {
  CHECK(values("n = 3") == Texts{"3"});
  CHECK(values("count = 3") == Texts{"3"});
  CHECK(values("input = '-'") == Texts{"-"});
  CHECK(values("output-format = 'obj'") == Texts{"obj"});
  CHECK(values("no-refine = true") == Texts{"false"});
  for (const char* wrong : {"INPUT = 'a'", "output_format = 'obj'", "-n = 3", "\"--count\" = 3", "N = 3", "help = true",
                            "config = 'a'", "refine = true"}) {
    CAPTURE(wrong);
    CHECK_THAT(refusal(wrong), StartsWith("f:1:1: ") && Contains("is not an option"));
  }
  CHECK(refusal("cuont = 3") == "f:1:1: cuont: is not an option; did you mean count?");
}

TEST_CASE("each option takes values of its type only") {
  CHECK(values("radius = 3") == Texts{"3"});
  CHECK(values("radius = 1e-300") == Texts{"1e-300"});
  CHECK(values("vertices = '3,17'") == Texts{"3,17"});
  CHECK(values("vertices = 3") == Texts{"3"});
  CHECK(values("vertices = [3, 17]") == Texts{"3", "17"});
  CHECK(values("levels = [3, 17]") == Texts{"3", "17"});
  CHECK(values("memory = '2G'") == Texts{"2G"});
  CHECK(values("memory = 1000000000") == Texts{"1000000000"});
  CHECK(values("cut = false") == Texts{"false"});
  CHECK(values("weld = true") == Texts{"true"});
  CHECK(values("weld = 0.5") == Texts{"0.5"});
  CHECK(values("relax = 3") == Texts{"3"});
  CHECK(values("relax = 'none'") == Texts{"none"});
  CHECK(values("relocate = true") == Texts{"true"});
  CHECK(values("features = 30") == Texts{"30"});
  CHECK(values("error = '3%'") == Texts{"3%"});
  CHECK(values("input = ['a', 'b']") == Texts{"a", "b"});
  for (const char* wrong : {"n = 3.0", "n = '3'", "n = [3]", "n = true", "radius = '1'", "vertices = 1.5",
                            "vertices = []", "vertices = [[1]]", "input = 3", "colour = ['a']", "cut = 1",
                            "cut = 'true'", "cut.a = 1", "memory = true", "page = 2020-01-01"}) {
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
  fixture.list.excludes("table", {"folder"});
  const std::string file = "n = 3\ntable = 'a.csv'\ncut = true\n";
  CHECK(fixture.left("count", {"9"}, file) == Texts{"table", "cut"});
  CHECK(fixture.left("radius", {"9"}, file) == Texts{"table", "cut"});
  CHECK(fixture.left("cut", {"false"}, file) == Texts{"count", "table"});
  CHECK(fixture.left("folder", {"a"}, file) == Texts{"count"});
  CHECK(fixture.left("folder", {"a"}, "cut = true\n").empty());
  CHECK(fixture.left("table", {"a"}, "cut = true\n") == Texts{"cut"});
}

TEST_CASE("a value of the line overrides what does nothing beside it") {
  const test::ScratchFolder scratch;
  const std::string path = scratch / "o.toml";
  const auto computed = [&](const std::string& toml, Texts arguments) {
    test::write_text(path, toml);
    arguments.insert(arguments.end(), {"a.obj", "-n", "3", "--config", path});
    return parse_options(arguments).diagram;
  };
  const std::string fast = "method = \"gbgvd\"\nfront = \"planar\"\n";
  CHECK(computed(fast, {"--method", "exact"}).front == std::nullopt);
  CHECK(computed(fast, {"--method", "paper"}).front == Front::planar);
  CHECK(computed(fast, {"--chord-tolerance", "1"}).method == Method::exact);
  CHECK(computed(fast, {"--chord-tolerance", "1"}).front == std::nullopt);
  CHECK(computed("chord-tolerance = 1\n", {"--method", "gbgvd"}).chord_tolerance == 1e-4);
  CHECK_THROWS_WITH(computed("front = \"planar\"\n", {}), Contains("o.toml:1:1: front has no effect here: add"));
  CHECK_THROWS_WITH(computed("method = \"paper\"\nchord-tolerance = 1\n", {}),
                    Contains("o.toml:1:1: method = \"paper\" and chord-tolerance exclude each other"));
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
  CHECK_THROWS_WITH(with(scratch / ""), Contains("is a directory; name a TOML file"));
  test::write_text(scratch / "a.toml", "n = 3\n");
  CHECK(with(scratch / "a.toml").generators.count == 3);
  CHECK(with(scratch / "a.toml").general.config == scratch / "a.toml");
}

}  // namespace gvd::test_config_file
