// A command line with an option of each kind: what it stores, what it refuses, and its help.

#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/command_line.hpp"
#include "common/options/typed_options.hpp"
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
    line.set_help_flag();
    line.footer("The footer.");
    line.add_option("INPUT", inputs, "The input")->required()->type_name("");
    const auto store = [this](const std::string& text) {
      even = text;
      return (text.back() - '0') % 2 == 0 ? "" : "'" + text + "' is odd";
    };
    add_parsed(line, "--even", "N", store, "An even number")->group("Numbers");
    line.add_option("--other", other, "A text")->type_name("TEXT")->excludes("--even");
    line.add_option("-f,--file", files, "Some files")->type_name("FILE")->allow_extra_args(false);
    add_flag(line, "--flag", flag, "A flag")->group("Numbers")->needs("--even");
    line.add_flag_callback(
            "-h", [] { throw CLI::CallForHelp(); }, "Show the main options")
        ->configurable(false);
    line.add_flag_callback(
            "--help", [] { throw CLI::CallForAllHelp(); }, "Show all options")
        ->configurable(false);
    line.set_version_flag("--version", "gvd-test 1.2", "Show the version");
    line.set_config("--config", "", "More options")->check(CLI::ExistingFile)->each([this](const std::string& file) {
      config = file;
    });
  }

  std::string refusal(const std::vector<std::string>& arguments) {
    return test::refusal([&] { parse_line(line, arguments); });
  }

  CLI::App line{"A test.", "gvd-test"};
  std::string even, other, config;
  std::vector<std::string> inputs, files;
  bool flag = false;
};

TEST_CASE("values, lists and flags are stored") {
  Fixture fixture;
  CHECK(!parse_line(fixture.line, {"-f", "a", "in", "--file", "b", "--even", "4", "--flag"}));
  CHECK(fixture.inputs == std::vector<std::string>{"in"});
  CHECK(fixture.even == "4");
  CHECK(fixture.files == std::vector<std::string>{"a", "b"});
  CHECK(fixture.flag);
}

TEST_CASE("a usage error names the option, what is wrong with it, and where the help is") {
  CHECK(Fixture().refusal({"in", "--even", "3"}) == "--even: '3' is odd (see gvd-test --help)");
  CHECK_THAT(Fixture().refusal({}), Contains("INPUT") && EndsWith("(see gvd-test --help)"));
  CHECK_THAT(Fixture().refusal({"in", "--unknown"}), Contains("--unknown"));
  CHECK(Fixture().refusal({"in", "--even", "2", "--other", "x"}) == "--even excludes --other (see gvd-test --help)");
  CHECK(Fixture().refusal({"in", "--even", "4", "--flag", "--fiel", "x"}) ==
        "unknown option: --fiel (did you mean --file?) (see gvd-test --help)");
  CHECK(Fixture().refusal({"in", "--flag", "--evne", "4"}) ==
        "unknown option: --evne (did you mean --even?) (see gvd-test --help)");
  CHECK_THAT(Fixture().refusal({"in", "--flag"}), Contains("--flag") && Contains("--even"));
  CHECK_THAT(Fixture().refusal({"in", "--even"}), Contains("--even"));
  CHECK_THAT(Fixture().refusal({"in", "--config", "/nonexistent.toml"}), Contains("/nonexistent.toml"));
}

TEST_CASE("a value that is missing, there twice or of a wrong kind is told as such") {
  CHECK(Fixture().refusal({"in", "--even"}) == "--even: 1 required N missing (see gvd-test --help)");
  CHECK(Fixture().refusal({"in", "--even", "2", "--even", "4"}) ==
        "--even: At Most 1 required but received 2 (see gvd-test --help)");
  CHECK_THAT(Fixture().refusal({"in", "--flag=maybe"}), StartsWith("--flag: 'maybe' is neither true nor false"));
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
  Fixture fixture;
  CHECK(!parse_line(fixture.line, {"in", "more", "still"}));
  CHECK(fixture.inputs == std::vector<std::string>{"in", "more", "still"});
}

TEST_CASE("after two dashes an argument may begin with a dash") {
  Fixture fixture;
  CHECK(!parse_line(fixture.line, {"--even", "4", "--", "-in"}));
  CHECK(fixture.inputs == std::vector<std::string>{"-in"});
  CHECK(!parse_line(fixture.line, {"--", "in", "--more"}));
  CHECK(fixture.inputs == std::vector<std::string>{"in", "--more"});
}

TEST_CASE("help and version are answers, even where a required argument is missing") {
  Fixture fixture;
  CHECK(parse_line(fixture.line, {"--version"}) == "gvd-test 1.2\n");
  const auto help = parse_line(fixture.line, {"--help"});
  REQUIRE(help);
  for (const char* part : {"A test.", "The footer.", "Usage: gvd-test [OPTIONS] INPUT...", "--even N",
                           "-f, --file FILE", "Numbers:", "Some files"}) {
    CHECK_THAT(*help, Contains(part));
  }
  const auto main = parse_line(fixture.line, {"-h"});
  REQUIRE(main);
  CHECK_THAT(*main, Contains("Usage: gvd-test [OPTIONS] INPUT...") &&
                        Contains("All options, and examples: gvd-test --help") && !Contains("--even"));
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
  CHECK(from_file.inputs == std::vector<std::string>{"a b"});
  CHECK(from_file.even == "8");
  CHECK(from_file.files == std::vector<std::string>{"x", "y"});
  CHECK(from_file.flag);
  overridden.parsed({"in", "--even", "2", "-f", "z", "--flag=false"});
  CHECK(overridden.inputs == std::vector<std::string>{"in"});
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
  CHECK_THAT(refused("\nodd = 8\n"), StartsWith(":2:1: odd: is not an option"));
  CHECK(refused("evne = 8\n") == ":1:1: evne: is not an option; did you mean even?");
  CHECK(refused("even = \"8\"\n") == ":1:8: even: expected a whole number, found a string");
  CHECK(refused("flag = 1\n") == ":1:8: flag: expected true or false, found a whole number");
  CHECK(refused("other = true\n") == ":1:9: other: expected a string in quotes, found a boolean");
  CHECK(refused("file = [\"x\", 3]\n") ==
        ":1:14: file: expected a string, or an array of strings, found a whole number");
  CHECK(refused("even = 7\n") == ":1:1: even: '7' is odd");
  CHECK(refused("f = \"x\"\nfile = \"y\"\n") == ":2:1: file: is the same option as f above");
  CHECK(refused("flag = true\n") == ":1:1: flag requires --even");
  CHECK(refused("even = 2\nother = \"x\"\n") == ":2:1: even excludes other");
  CHECK_THAT(refused("even = [ 12\n"), StartsWith(":") && Contains("not valid TOML"));
}

TEST_CASE("words wrap before the width, and a longer word stands alone") {
  CHECK(wrap("one two three", 7, 2) == "one two\n  three");
  CHECK(wrap("one two three", 6, 0) == "one\ntwo\nthree");
  CHECK(wrap("a verylongword b", 5, 1) == "a\n verylongword\n b");
  CHECK(wrap("  ", 5, 1).empty());
}

TEST_CASE("options are listed in groups, in the order in which each comes first") {
  CLI::App line("A test that has a description of so many words that they do not fit into one line of the help.", "x");
  line.set_help_flag();
  std::string text;
  std::vector<std::string> texts;
  line.add_option("INPUT", texts, "The mesh")->group("Input")->type_name("");
  line.add_option("--output-with-a-long-name", text, "Write it")->group("Output")->type_name("FILE");
  line.add_option("--input-format", text, "Its format")->group("Input")->type_name("F");
  bool quiet = false;
  add_flag(line, "-q,--quiet", quiet, "Say nothing but errors")->group("General");
  line.footer("\nThe end.\n");
  line.formatter(std::make_shared<HelpFormatter>());
  CHECK(line.help("", CLI::AppFormatMode::All) ==
        "A test that has a description of so many words that they do not fit into one\n"
        "line of the help.\n"
        "\nUsage: x [OPTIONS] [INPUT...]\n"
        "\nInput:\n"
        "  INPUT                   The mesh\n"
        "  --input-format F        Its format\n"
        "\nOutput:\n"
        "  --output-with-a-long-name FILE\n"
        "                          Write it\n"
        "\nGeneral:\n"
        "  -q, --quiet             Say nothing but errors\n"
        "\nThe end.\n");
}

const std::vector<std::string> kNames{"-n",     "--count", "--sampling",      "--seed",   "--generators",
                                      "--view", "-o",      "--output-format", "--output", "--radius",
                                      "--cut",  "-h",      "--help",          "--method", "--threads"};

TEST_CASE("a misspelt option is told from few letters that differ") {
  CHECK(suggest_name("--smapling", kNames) == "--sampling");  // a swap
  CHECK(suggest_name("--samplin", kNames) == "--sampling");
  CHECK(suggest_name("--samplings", kNames) == "--sampling");
  CHECK(suggest_name("--sanplimg=random", kNames) == "--sampling");
  CHECK(suggest_name("-sampling", kNames) == "--sampling");
  CHECK(suggest_name("--generater", kNames) == "--generators");
  CHECK(suggest_name("--cat", kNames) == "--cut");
  CHECK(suggest_name("--n", kNames) == "-n");
}

TEST_CASE("the beginning of an option stands for the shortest that begins so") {
  CHECK(suggest_name("--out", kNames) == "--output");
  CHECK(suggest_name("--gen", kNames) == "--generators");
  CHECK(suggest_name("--output-f", kNames) == "--output-format");
}

TEST_CASE("beginnings of an option's words stand for it, with dashes between them or not") {
  CHECK(suggest_name("--out-f", kNames) == "--output-format");
  CHECK(suggest_name("--outform", kNames) == "--output-format");
  CHECK(suggest_name("--outputformat", kNames) == "--output-format");
  CHECK(!suggest_name("--format", kNames));
}

TEST_CASE("capitals do not count, and the same name goes before a longer one") {
  CHECK(suggest_name("--OUTPUT", kNames) == "--output");
  CHECK(suggest_name("--Samplign", kNames) == "--sampling");
  CHECK(suggest_name("-N", kNames) == "-n");
}

TEST_CASE("the name of what is not an option is known from its first letter on") {
  std::vector<std::string> names = kNames;
  names.insert(names.end(), {"INPUT", "--input-format"});
  for (const char* wrong : {"-i", "--in", "--input", "--Input", "--input=a.obj"}) {
    CAPTURE(wrong);
    CHECK(suggest_name(wrong, names) == "INPUT");
  }
  CHECK(suggest_name("--input-f", names) == "--input-format");
}

TEST_CASE("what is like no option gets no suggestion") {
  for (const char* wrong : {"--nonsense", "--x", "-x", "-", "--", "--=3", "--qq"}) {
    CAPTURE(wrong);
    CHECK(!suggest_name(wrong, kNames));
  }
  CHECK(!suggest_name("--seed", {}));
  CHECK(!suggest_name(std::string(1 << 24, 's'), kNames));  // at once
}

}  // namespace gvd::test_command_line
