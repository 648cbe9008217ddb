// A command line with an option of each kind: what it stores, what it refuses, and its help.

#include "apps/run_command.hpp"
#include "common/options/command_line.hpp"
#include "gvd/version.hpp"
#include "options/toy_options.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_command_line {

using namespace app;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using Texts = std::vector<std::string>;

/// A toy command, and what it understood.
struct Line : test::Toy {
  Line() { app::describe(list, general); }

  std::optional<std::string> parse(const Texts& words) {
    return parse_command_line({"gvd-test", "A test.", "  gvd-test a\n"}, list, given, words);
  }
  std::string refusal(const Texts& words) {
    return test::refusal([&] { parse(words); });
  }

  GeneralOptions general;
  Given given;
};

std::string refusal(const Texts& words) { return Line().refusal(words); }

constexpr const char* kHint = " (see gvd-test --help)";

TEST_CASE("values, lists and flags are stored") {
  Line line;
  CHECK(!line.parse({"-o", "a", "in", "--output", "b", "--count", "4", "--table", "t.csv", "--cut", "--no-refine"}));
  CHECK(line.options.inputs == Texts{"in"});
  CHECK(line.options.count == 4);
  CHECK(line.options.outputs == Texts{"a", "b"});
  CHECK(line.options.cut);
  CHECK(!line.options.refine);
  for (const char* name : {"input", "output", "count", "cut", "refine", "table"}) CHECK(line.given.has(name));
  CHECK(!line.given.has("seed"));
}

TEST_CASE("a value may stand behind an equals sign or a letter, and flags may stand together") {
  Line line;
  CHECK(!line.parse({"-n5", "--output=a", "-vo", "b", "in", "--table=t.csv", "--cut=true", "more"}));
  CHECK(line.options.count == 5);
  CHECK(line.options.outputs == Texts{"a", "b"});
  CHECK(line.general.verbose);
  CHECK(line.options.cut);
  CHECK(line.options.inputs == Texts{"in", "more"});
  Line joined;
  joined.parse({"in", "-qn7"});
  CHECK((joined.general.quiet && joined.options.count == 7));
}

TEST_CASE("a value may begin with a dash, unless it is the name of an option") {
  Line line;
  CHECK(!line.parse({"in", "-o", "-", "--density", "-x", "-n", "3"}));
  CHECK(line.options.outputs == Texts{"-"});
  CHECK(line.options.density.name == "-x");
  CHECK(refusal({"in", "--density", "-o", "eq.ply"}) ==
        std::string("--density: its value is missing; write --density area|FILE|PROPERTY") + kHint);
  CHECK(refusal({"in", "--density", "--output=eq.ply"}) ==
        std::string("--density: its value is missing; write --density area|FILE|PROPERTY") + kHint);
  CHECK(refusal({"in", "-n", "-1"}) == std::string("-n: '-1' is not a whole number from 1 to 2147483647") + kHint);
  CHECK(refusal({"in", "--from", "-1"}) ==
        std::string("--from: '-1' is not a vertex index; write indices from 0, as in 3,17,99") + kHint);
}

TEST_CASE("a name that may stand alone takes only what is surely its value") {
  const auto weld = [](const Texts& words) {
    Line line;
    line.parse(words);
    return std::pair(line.options.weld, line.options.inputs);
  };
  CHECK(weld({"--weld", "in"}) == std::pair(std::optional(0.0), Texts{"in"}));
  CHECK(weld({"--weld", "0.5", "in"}) == std::pair(std::optional(0.5), Texts{"in"}));
  CHECK(weld({"in", "--weld=0.5"}) == std::pair(std::optional(0.5), Texts{"in"}));
  const auto page = [](const Texts& words) {
    Line line;
    line.parse(words);
    return std::pair(line.options.unnamed_page ? "alone" : line.options.page, line.options.inputs);
  };
  CHECK(page({"in", "--page", "a.html"}) == std::pair(std::string("a.html"), Texts{"in"}));
  CHECK(page({"--page", "a.html", "in"}) == std::pair(std::string("a.html"), Texts{"in"}));
  CHECK(page({"--page", "in"}) == std::pair(std::string("alone"), Texts{"in"}));
  CHECK(page({"in", "--page", "-q"}) == std::pair(std::string("alone"), Texts{"in"}));
  CHECK(page({"in", "--page"}) == std::pair(std::string("alone"), Texts{"in"}));
}

TEST_CASE("a usage error names the option as it was typed, what is wrong with it, and where the help is") {
  CHECK(refusal({"in", "-n", "2.5"}) == std::string("-n: '2.5' is not a whole number from 1 to 2147483647") + kHint);
  CHECK(refusal({"in", "--count", "2.5"}) ==
        std::string("--count: '2.5' is not a whole number from 1 to 2147483647") + kHint);
  CHECK(refusal({"-n", "3"}) == std::string("INPUT is required") + kHint);
  CHECK(refusal({"in", "-n", "2", "--radius", "1"}) == "-n and --radius exclude each other: keep one");
  CHECK(refusal({"in", "--cut"}) == "--cut needs --table: add it, or leave --cut out");
  CHECK(refusal({"in", "--colour", "red", "--front", "red"}) ==
        "--front has no effect here: add --colour green, or leave --front out");
  CHECK(refusal({"in", "--no-refine=maybe"}) == std::string("--no-refine: 'maybe' is neither true nor false") + kHint);
}

TEST_CASE("a value that is missing or there twice is told as such") {
  CHECK(refusal({"in", "--table"}) == std::string("--table: its value is missing; write --table FILE.csv") + kHint);
  CHECK(refusal({"in", "-n"}) == std::string("-n: its value is missing; write -n N") + kHint);
  CHECK(refusal({"in", "-n", "2", "--count", "4"}) == std::string("-n: given twice; keep one") + kHint);
  CHECK(refusal({"in", "--config"}) == std::string("--config: its value is missing; write --config FILE.toml") + kHint);
  CHECK_THAT(refusal({"in", "--config", "/nonexistent.toml"}),
             StartsWith("--config /nonexistent.toml: there is no such file that can be read"));
  CHECK(refusal({"--print-completion"}) ==
        std::string("--print-completion: its value is missing; write --print-completion bash|zsh|fish") + kHint);
  CHECK(refusal({"--print-completion", "ksh"}) ==
        std::string("--print-completion: 'ksh' is not one of bash|zsh|fish; did you mean zsh?") + kHint);
}

TEST_CASE("a flag that is turned off is as good as not given") {
  Line off;
  CHECK(!off.parse({"in", "--cut=false", "--no-refine=false"}));
  CHECK((!off.options.cut && off.options.refine));
  CHECK((!off.given.has("cut") && !off.given.has("refine")));
  Line last;
  CHECK(!last.parse({"in", "--cut", "--cut=no"}));
  CHECK(!last.options.cut);
}

TEST_CASE("the name of a positional argument that is given as an option needs none") {
  CHECK(refusal({"--input", "in"}) == std::string("unknown option: --input (INPUT needs no option in front)") + kHint);
}

TEST_CASE("unknown options are named in the order typed, before all else that is wrong") {
  CHECK(refusal({"in", "--cuont", "2"}) == std::string("unknown option: --cuont (did you mean --count?)") + kHint);
  CHECK(refusal({"-n", "x", "--zzz", "--sed", "x", "--outptu=3"}) ==
        std::string("unknown options: --zzz, --sed (did you mean --seed?), --outptu=3 (did you mean --output?)") +
            kHint);
  CHECK(refusal({"in", "-x"}) == std::string("unknown option: -x") + kHint);
}

TEST_CASE("after two dashes an argument may begin with a dash") {
  Line line;
  CHECK(!line.parse({"-n", "4", "--", "-in", "--more"}));
  CHECK(line.options.inputs == Texts{"-in", "--more"});
}

TEST_CASE("a question is answered whatever else is wrong") {
  CHECK(*Line().parse({"-n", "x", "--version", "--nonsense"}) == "gvd-test " + std::string(version()) + "\n");
  CHECK_THAT(*Line().parse({"--help"}), StartsWith("A test.\n\nUsage: gvd-test [OPTIONS] INPUT...\n") &&
                                            Contains("\nOutput:\n") &&
                                            Contains("\nExamples:\n  gvd-test a\n\nExit codes: 0 done, 2 usage, "));
  CHECK_THAT(*Line().parse({"-h", "--help"}), EndsWith("All options, and examples: gvd-test --help\n"));
  CHECK_THAT(*Line().parse({"--print-options"}), StartsWith("{\n \"options\": [\n  {\n   \"name\": \"input\""));
}

TEST_CASE("a file of options goes behind the command line") {
  const test::ScratchFolder scratch;
  const std::string path = scratch / "o.toml";
  const auto with = [&](const std::string& text, Texts words) {
    test::write_text(path, text);
    words.insert(words.end(), {"--config", path});
    return words;
  };
  const std::string text =
      "count = 8\noutput = [\"x\", \"y\"]\ncut = true\ntable = 't.csv'\ninput = 'a b'\nno-refine = true\n";
  Line file, both;
  CHECK(!file.parse(with(text, {})));
  CHECK(file.general.config == path);
  CHECK(file.options.inputs == Texts{"a b"});
  CHECK(file.options.count == 8);
  CHECK(file.options.outputs == Texts{"x", "y"});
  CHECK((file.options.cut && !file.options.refine));
  CHECK(!both.parse(with(text, {"in", "-n", "2", "-o", "z", "--cut=false"})));
  CHECK(both.options.inputs == Texts{"in"});
  CHECK(both.options.count == 2);
  CHECK(both.options.outputs == Texts{"z"});
  CHECK(!both.options.cut);
  Line radius;
  CHECK(!radius.parse(with(text, {"--radius", "2"})));
  CHECK(!radius.options.count);
  Line red;
  CHECK(!red.parse(with("front = 'red'\n", {"in", "--colour", "red"})));
  CHECK(!red.options.front);
  CHECK(!red.given.has("front"));
  const auto refused = [&](const std::string& toml, const Texts& words) {
    const std::string message = refusal(with(toml, words));
    CHECK_THAT(message, StartsWith(path));
    return message.substr(std::min(path.size(), message.size()));
  };
  CHECK(refused("count = 0\n", {"in"}) == ":1:1: count: '0' is not a whole number from 1 to 2147483647");
  CHECK(refused("seed = 1\ncut = true\n", {"in"}) == ":2:1: cut needs table: add it, or leave cut out");
  CHECK(refused("n = 2\nradius = 1.0\n", {"in"}) == ":2:1: n and radius exclude each other: keep one");
  CHECK(refused("front = 'red'\ncolour = 'red'\n", {"in"}) ==
        ":1:1: front has no effect here: add colour = \"green\", or leave front out");
}

}  // namespace gvd::test_command_line
