#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/command_line.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_command_line {

using namespace app;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using gvd::test::parse_line;

/// A command line with an option of each kind, and what it stored.
struct Fixture {
  Fixture() {
    line.add_value({"INPUT", "", "The input"}, [this](const std::string& text) {
      input = text;
      return std::optional<std::string>();
    });
    line.add_value({"--even", "N", "An even number", "Numbers", {}, {"--other"}, ValueKind::whole},
                   [this](const std::string& text) {
                     even = text;
                     return (text.back() - '0') % 2 == 0 ? std::nullopt
                                                         : std::optional<std::string>("'" + text + "' is odd");
                   });
    line.add_value({"--other", "TEXT", "A text"}, [this](const std::string& text) {
      other = text;
      return std::optional<std::string>();
    });
    line.add_list({"-f,--file", "FILE", "Some files"}, [this](const std::vector<std::string>& all) { files = all; });
    line.add_flag({"--flag", "", "A flag", "Numbers", {"--even"}}, flag);
    line.add_config({"--config", "FILE.toml", "More options"}, config);
  }

  std::string refusal(const std::vector<std::string>& arguments) {
    return test::refusal([&] { parse_line(line, arguments); });
  }

  CommandLine line{"gvd-test", "A test.", "gvd-test 1.2", "The footer."};
  std::string input, even, other, config;
  std::vector<std::string> files;
  bool flag = false;
};

TEST_CASE("values, lists and flags are stored") {
  Fixture fixture;
  CHECK(!parse_line(fixture.line, {"-f", "a", "in", "--file", "b", "--even", "4", "--flag"}));
  CHECK(fixture.input == "in");
  CHECK(fixture.even == "4");
  CHECK(fixture.files == std::vector<std::string>{"a", "b"});
  CHECK(fixture.flag);
}

TEST_CASE("a usage error names the option, what is wrong with it, and where the help is") {
  CHECK(Fixture().refusal({"in", "--even", "3"}) == "--even: '3' is odd (see gvd-test --help)");
  CHECK_THAT(Fixture().refusal({}), Contains("INPUT") && EndsWith("(see gvd-test --help)"));
  CHECK_THAT(Fixture().refusal({"in", "--unknown"}), Contains("--unknown"));
  CHECK(Fixture().refusal({"in", "--even", "2", "--other", "x"}) == "--even and --other exclude each other: keep one");
  CHECK_THAT(Fixture().refusal({"in", "more"}), Contains("more"));
  CHECK_THAT(Fixture().refusal({"in", "--flag"}), Contains("--flag") && Contains("--even"));
  CHECK_THAT(Fixture().refusal({"in", "--even"}), Contains("--even"));
  CHECK_THAT(Fixture().refusal({"in", "--config", "/nonexistent.toml"}), Contains("/nonexistent.toml"));
}

TEST_CASE("a value that is missing, there twice or behind a stray = is told as such") {
  CHECK(Fixture().refusal({"in", "--even"}) == "--even: its value is missing; write --even N (see gvd-test --help)");
  CHECK(Fixture().refusal({"in", "--even", "2", "--even", "4"}) ==
        "--even: is there several times; keep one (see gvd-test --help)");
  CHECK(Fixture().refusal({"in", "-f=a"}) == "-f: '=a' begins with =; write -f a (see gvd-test --help)");
  CHECK_THAT(Fixture().refusal({"in", "--flag=maybe"}), StartsWith("--flag = maybe: expected true or false"));
  Fixture fixture;
  CHECK(!parse_line(fixture.line, {"in", "--file=a"}));
  CHECK(fixture.files == std::vector<std::string>{"a"});
}

TEST_CASE("the name of a positional argument that is given as an option needs none") {
  CHECK(Fixture().refusal({"--input", "in"}) ==
        "unknown option: --input (INPUT needs no option in front) (see gvd-test --help)");
}

TEST_CASE("unknown options are named in the order typed, each with the one that it may stand for") {
  CHECK(Fixture().refusal({"in", "--evne", "2"}) ==
        "unknown option: --evne (did you mean --even?) (see gvd-test --help)");
  CHECK(
      Fixture().refusal({"in", "--zzz", "--oter", "x", "--fiel=3"}) ==
      "unknown options: --zzz, --oter (did you mean --other?), --fiel=3 (did you mean --file?) (see gvd-test --help)");
  CHECK(Fixture().refusal({"in", "more", "still"}) == "unexpected: more, still (see gvd-test --help)");
}

TEST_CASE("after two dashes an argument may begin with a dash") {
  Fixture fixture;
  CHECK(!parse_line(fixture.line, {"--even", "4", "--", "-in"}));
  CHECK(fixture.input == "-in");
  CHECK(Fixture().refusal({"--", "in", "--more"}) == "unexpected: --more (see gvd-test --help)");
}

TEST_CASE("help and version are answers, even where a required argument is missing") {
  Fixture fixture;
  CHECK(parse_line(fixture.line, {"--version"}) == "gvd-test 1.2\n");
  for (const char* name : {"-h", "--help"}) {
    const auto help = parse_line(fixture.line, {name});
    REQUIRE(help);
    for (const char* part : {"A test.", "The footer.", "Usage: gvd-test INPUT [options]", "--even N", "-f, --file FILE",
                             "Numbers:", "Some files"}) {
      CHECK_THAT(*help, Contains(part));
    }
  }
}

/// A fixture that has read a file of options, and the refusal of one that it can't read.
struct ConfigFixture : Fixture {
  explicit ConfigFixture(const std::string& text) { test::write_text(path, text); }

  Fixture& parsed(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--config", path});
    parse_line(line, arguments);
    return *this;
  }
  /// Without the path of the file.
  std::string refused(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--config", path});
    const std::string message = refusal(arguments);
    return message.rfind(path, 0) == 0 ? message.substr(path.size()) : message;
  }

  test::ScratchFolder scratch;
  std::string path = scratch / "a.toml";
};

TEST_CASE("a configuration file gives what the command line does not, the input too") {
  const std::string text = "even = 8\nfile = [\"x\", \"y\"]\nflag = true\ninput = 'a b'\n";
  ConfigFixture from_file(text), overridden(text);
  from_file.parsed({});
  CHECK(from_file.config == from_file.path);
  CHECK(from_file.input == "a b");
  CHECK(from_file.even == "8");
  CHECK(from_file.files == std::vector<std::string>{"x", "y"});
  CHECK(from_file.flag);
  overridden.parsed({"in", "--even", "2", "-f", "z", "--flag=false"});
  CHECK(overridden.input == "in");
  CHECK(overridden.even == "2");
  CHECK(overridden.files == std::vector<std::string>{"z"});
  CHECK(!overridden.flag);
}

TEST_CASE("an option of the command line takes the place of those of the file that it excludes") {
  ConfigFixture fixture("even = 8\nflag = true\n");
  fixture.parsed({"in", "--other", "x"});
  CHECK(fixture.even.empty());
  CHECK(!fixture.flag);  // it needs --even
  CHECK(fixture.other == "x");
}

TEST_CASE("an error in a configuration file has line, column, key and what was expected") {
  const auto refused = [](const std::string& text) { return ConfigFixture(text).refused({"in"}); };
  CHECK_THAT(refused("\nodd = 8\n"), StartsWith(":2:1: odd: is no option"));
  CHECK(refused("evne = 8\n") == ":1:1: evne: is no option; did you mean even?");
  CHECK(refused("even = \"8\"\n") == ":1:8: even: expected a whole number, found a string");
  CHECK(refused("flag = 1\n") == ":1:8: flag: expected true or false, found a whole number");
  CHECK(refused("other = true\n") == ":1:9: other: expected a string in quotes, found a boolean");
  CHECK(refused("file = [\"x\", 3]\n") ==
        ":1:14: file: expected a string, or an array of strings, found a whole number");
  CHECK(refused("even = 7\n") == ":1:1: even: '7' is odd");
  CHECK(refused("f = \"x\"\nfile = \"y\"\n") == ":2:1: file: is the same option as f above");
  CHECK(refused("flag = true\n") == ":1:1: flag does nothing here: add --even, or leave flag out");
  CHECK_THAT(refused("even = 2\nother = \"x\"\n"), Contains("even and other exclude each other"));
  CHECK_THAT(refused("even = [ 12\n"), StartsWith(":") && Contains("no TOML"));
}

}  // namespace gvd::test_command_line
