#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/command_line.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::app;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using gvd::test::parse_line;

namespace {

/// A command line with an option of each kind, and what it stored.
struct Fixture {
  Fixture() {
    line.add_value({"INPUT", "", "The input"}, [this](const std::string& text) {
      input = text;
      return std::optional<std::string>();
    });
    line.add_value({"--even", "N", "An even number", "Numbers"}, [this](const std::string& text) {
      even = text;
      return (text.back() - '0') % 2 == 0 ? std::nullopt : std::optional<std::string>("'" + text + "' is odd");
    });
    line.add_list({"-f,--file", "FILE", "Some files"}, [this](const std::vector<std::string>& all) { files = all; });
    line.add_flag({"--flag", "", "A flag", "Numbers", "--even"}, flag);
    line.add_config({"--config", "FILE.toml", "More options"});
  }

  std::string refusal(const std::vector<std::string>& arguments) {
    try {
      parse_line(line, arguments);
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::invalid_option);
      return error.what();
    }
    return "nothing was refused";
  }

  CommandLine line{"gvd-test", "A test.", "gvd-test 1.2", "The footer."};
  std::string input, even;
  std::vector<std::string> files;
  bool flag = false;
};

}  // namespace

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
  CHECK_THAT(Fixture().refusal({"in", "--other"}), Contains("--other"));
  CHECK_THAT(Fixture().refusal({"in", "more"}), Contains("more"));
  CHECK_THAT(Fixture().refusal({"in", "--flag"}), Contains("--flag") && Contains("--even"));
  CHECK_THAT(Fixture().refusal({"in", "--even"}), Contains("--even"));
  CHECK_THAT(Fixture().refusal({"in", "--config", "/nonexistent.toml"}), Contains("/nonexistent.toml"));
}

TEST_CASE("help and version are answers, even where a required argument is missing") {
  Fixture fixture;
  CHECK(parse_line(fixture.line, {"--version"}) == "gvd-test 1.2\n");
  for (const char* name : {"-h", "--help"}) {
    const auto help = parse_line(fixture.line, {name});
    REQUIRE(help);
    for (const char* part :
         {"A test.", "The footer.", "INPUT", "--even N", "-f,--file FILE", "Numbers:", "Some files"}) {
      CHECK_THAT(*help, Contains(part));
    }
  }
}

TEST_CASE("a configuration file gives what the command line does not") {
  const test::ScratchFolder scratch;
  test::write_text(scratch / "a.toml", "even = 8\nfile = [\"x\", \"y\"]\n");
  Fixture fixture, overridden;
  parse_line(fixture.line, {"in", "--config", scratch / "a.toml"});
  CHECK(fixture.even == "8");
  CHECK(fixture.files == std::vector<std::string>{"x", "y"});
  parse_line(overridden.line, {"in", "--even", "2", "--config", scratch / "a.toml"});
  CHECK(overridden.even == "2");
  test::write_text(scratch / "b.toml", "odd = 8\n");
  CHECK_THAT(Fixture().refusal({"in", "--config", scratch / "b.toml"}), Contains("odd"));
}
