// gvd, the program that all commands are: which command a call means, and what gvd itself answers.

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_gvd_command {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

struct Known {
  std::string name, work;  ///< the options of a short run
};

const std::vector<Known> kCommands{{"segment", "-n 5 -o out.ply"},
                                   {"lloyd", "-n 5 --iterations 2 -o out.ply"},
                                   {"remesh", "-n 12 --relax none -o out.ply"},
                                   {"distance", "--from 0,9 -o out.ply"}};

/// A call of a program in a folder, with what it writes there.
struct Outcome {
  CommandResult result;
  std::string file, report;  ///< out.ply and the report, but for times and memory
};

Outcome call(const std::string& program, const std::string& arguments) {
  const ScratchFolder folder;
  Outcome outcome;
  outcome.result = run_command("/bin/sh", "-c \"cd '" + folder / "" + "' && exec " + program + " " + arguments + '"');
  outcome.file = read_text(folder / "out.ply");
  const std::string text = read_text(folder / "report.json");
  if (!text.empty()) {
    auto report = nlohmann::ordered_json::parse(text);
    report.erase("timings_ms");
    report.erase("peak_memory_bytes");
    outcome.report = report.dump();
  }
  return outcome;
}

bool operator==(const Outcome& a, const Outcome& b) {
  return std::tie(a.result.exit_code, a.result.out, a.result.err, a.file, a.report) ==
         std::tie(b.result.exit_code, b.result.out, b.result.err, b.file, b.report);
}

TEST_CASE("gvd: its version is that of the commands") {
  const std::string version = run_command("gvd", "--version").out;
  CHECK("gvd-segment" + version.substr(3) == run_command("gvd-segment", "--version").out);
  CHECK(run_command("gvd", "version").out == version);
}

// Which command a call means is found before its arguments are looked at. So each way is tried with a run and with a
// mistake, and the first one with all arguments.
TEST_CASE("gvd: each name and way of calling a command gives the same files, words and exit codes") {
  const std::string bin = GVD_BIN_DIR, mesh = data_file("torus.ply");
  const ScratchFolder links;
  std::filesystem::create_symlink(bin + "/gvd", links / "gvd");
  for (const auto& [name, work] : kCommands) {
    const std::string link = "gvd-" + name;
    std::filesystem::create_symlink(bin + "/gvd", links / link);                // as packages have them
    std::filesystem::create_symlink(bin + '/' + link, links / ("my-" + name));  // a user's own name
    std::filesystem::create_symlink("my-" + name, links / ("our-" + name));     // relative, over two more links
    const std::string on_path = "env PATH='" + links / "" + ":/usr/bin:/bin' ";
    const std::vector<std::string> ways{bin + "/gvd " + name,
                                        bin + "/gvd " + link,
                                        links / link,
                                        links / "gvd " + name,
                                        links / ("my-" + name),
                                        links / ("our-" + name),
                                        on_path + link,
                                        on_path + "gvd " + name,
                                        on_path + "our-" + name,
                                        "bash -c 'exec -a " + link + " " + bin + "/gvd \\$*' -"};
    const std::vector<std::pair<std::string, int>> calls{{mesh + ' ' + work + " --report report.json", 0},
                                                         {mesh + " --nonsense", 2},
                                                         {"--help", 0},
                                                         {"-h", 0},
                                                         {"--version", 0},
                                                         {"--print-options", 0},
                                                         {"--print-completion fish", 0},
                                                         {"", 2},
                                                         {"missing.ply " + work, 3},
                                                         {mesh + ' ' + work + " -o missing/out.ply", 6}};
    constexpr std::size_t kTriedInEachWay = 2;
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const auto& [arguments, exit_code] = calls[i];
      const Outcome usual = call(bin + '/' + link, arguments);
      CAPTURE(name, arguments, usual.result.out, usual.result.err);
      CHECK(usual.result.exit_code == exit_code);
      const std::vector<std::string> tried(ways.begin(), i < kTriedInEachWay ? ways.end() : ways.begin() + 1);
      for (const std::string& way : tried) {
        const Outcome other = call(way, arguments);
        CAPTURE(way, other.result.exit_code, other.result.out, other.result.err);
        CHECK(usual == other);
      }
    }
  }
}

TEST_CASE("gvd: a command has one name in messages, help and reports, however it is called") {
  const std::string mesh = data_file("torus.ply");
  const Outcome done = call(GVD_BIN_DIR "/gvd segment", mesh + " -n 5 -o out.ply --report report.json");
  CHECK_THAT(done.result.err, StartsWith("gvd-segment: 5 cells") && Contains("\ngvd-segment: wrote out.ply"));
  CHECK(nlohmann::json::parse(done.report).at("command") == "gvd-segment");
  CHECK_THAT(run_command("gvd", "segment --help").out, Contains("Usage: gvd-segment [OPTIONS] INPUT...\n"));
  const CommandResult wrong = run_command("gvd", "segment " + mesh + " --nonsense");
  CHECK_THAT(wrong.err, StartsWith("gvd-segment: error: unknown option: --nonsense (see gvd-segment --help)"));
  const CommandResult stopped = run_interrupted("gvd", {"segment", "-", "--input-format", "off", "-n", "3"}, 2);
  CHECK(stopped.exit_code == 130);
  CHECK_THAT(stopped.err, StartsWith("gvd-segment: "));
}

TEST_CASE("gvd: alone, and asked for help, it says which command does what") {
  const CommandResult help = run_command("gvd", "--help");
  CHECK(help.exit_code == 0);
  CHECK(help.err.empty());
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(line.size() <= 80);
  }
  std::istringstream all(help.out);
  std::string words;
  for (std::string word; all >> word;) words += word + ' ';
  for (const Known& command : kCommands) {
    const std::string own = run_command("gvd-" + command.name, "-h").out;
    std::istringstream first(own.substr(0, own.find("\n\n")));
    std::string description = command.name + ' ';
    for (std::string word; first >> word;) description += word + ' ';
    CHECK_THAT(words, Contains(description));  // the command's own words
    CHECK_THAT(help.out, Contains("\n  gvd " + command.name + " bunny.obj "));
  }
  for (const char* question : {"-h", "help", "help help", "help -h"})
    CHECK(run_command("gvd", question).out == help.out);
  const CommandResult alone = run_command("gvd", "");
  CHECK(alone.out == help.out);
  CHECK(alone.exit_code == 2);  // nothing was done
  CHECK(run_command("gvd", "--help > /dev/full").exit_code == 6);
}

TEST_CASE("gvd: help of a command is that of the command") {
  for (const Known& command : kCommands) {
    const std::string help = run_command("gvd-" + command.name, "--help").out;
    for (const std::string& asked : {"help " + command.name, "--help " + command.name, "help gvd-" + command.name}) {
      const CommandResult result = run_command("gvd", asked);
      CHECK(result.exit_code == 0);
      CHECK(result.out == help);
    }
    CHECK(run_command("gvd", "-h " + command.name).out == run_command("gvd-" + command.name, "-h").out);
  }
}

TEST_CASE("gvd: a word that is no command is refused in one line that says what to do") {
  for (const char* call : {"segmnt", "help segmnt", "--help Segment"}) {
    require_error("gvd", call, 2, "(did you mean segment?) (see gvd --help)");
  }
  require_error("gvd", "dist mesh.obj", 2, "gvd: error: unknown command: dist (did you mean distance?)");
  require_error("gvd", "hlep", 2, "(did you mean help?)");
  require_error("gvd", "xyzzy", 2, "gvd: error: unknown command: xyzzy (see gvd --help)");
  for (const std::string& input : {std::string("mesh.obj"), std::string("-"), std::string(GVD_SOURCE_DIR "/LICENSE")}) {
    require_error("gvd", input + " -n 5", 2, "; name a command in front of it, as in gvd segment " + input);
  }
  require_error("gvd", "-n 5 segment", 2,
                "unknown option: -n; options of a command follow its name, as in gvd segment -n");
  require_error("gvd", "--versoin", 2, "unknown option: --versoin (did you mean --version?)");
}

TEST_CASE("gvd: its completion has the commands and all that they complete") {
  for (const std::string& shell : {std::string("bash"), std::string("zsh"), std::string("fish")}) {
    const CommandResult script = run_command("gvd", "--completion " + shell);
    CHECK(script.exit_code == 0);
    for (const Known& command : kCommands) {
      CHECK_THAT(script.out, Contains(run_command("gvd-" + command.name, "--print-completion " + shell).out));
    }
    CHECK(run_command("gvd", "--completion=" + shell).out == script.out);
    CHECK(run_command("gvd", "--print-completion " + shell).out == script.out);  // as the commands spell it
  }
  require_error("gvd", "--completion", 2, "--completion: its value is missing; write --completion bash|zsh|fish");
  require_error("gvd", "--completion ksh", 2, "--completion: 'ksh' is not one of bash|zsh|fish; did you mean zsh?");
  require_error("gvd", "--completion bash zsh", 2, "--completion: given twice; keep one");
}

/// What bash offers for the last of these words.
std::string completed(const std::string& words, int last) {
  const std::string bin = GVD_BIN_DIR;
  const ScratchFolder scratch;
  write_text(scratch / "ask", "source <(" + bin + "/gvd --completion bash)\nCOMP_WORDS=(" + words + ") COMP_CWORD=" +
                                  std::to_string(last) + "\n_${COMP_WORDS[0]//-/_}\necho ${COMPREPLY[*]}\n");
  const int status = std::system(("bash " + scratch / "ask" + " > " + scratch / "answer").c_str());
  CHECK(status == 0);
  return ' ' + read_text(scratch / "answer");
}

TEST_CASE("gvd: completion offers each word of a list once, and knows the commands by their full names") {
  const std::string first = completed("gvd-distance --output-format ''", 2);
  CHECK_THAT(first, Contains(" ply ") && Contains(" obj "));
  const std::string second = completed("gvd-distance --output-format ply,", 2);
  CHECK_THAT(second, Contains(" ply,obj ") && !Contains(" ply,ply "));
  const std::string third = completed("gvd-distance --output-format ply,obj,", 2);
  CHECK_THAT(third, Contains(" ply,obj,vtp ") && !Contains(" ply,obj,ply ") && !Contains(" ply,obj,obj "));
  CHECK(completed("gvd gvd-segment --bal", 2) == " --balance\n");
  CHECK(completed("gvd segment --bal", 2) == " --balance\n");
}

}  // namespace gvd::test_gvd_command
