// Standard streams of the commands: pipes, terminals and signals.

#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_command_streams {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("commands: a reader that goes away ends the run without a word") {
  for (const std::string& name : built_commands()) {
    const std::string command = "'" + std::string(GVD_BIN_DIR) + "/" + name + "' ";
    const auto piped = [&](const std::string& arguments) {
      return run_command("/bin/bash", "-c \"" + command + arguments + " | true; echo \\${PIPESTATUS[0]}\"");
    };
    // More than a pipe holds.
    const CommandResult data = piped(data_file("torus.ply") + " -n 400 -q -o - --output-format json");
    CAPTURE(name);
    CHECK(data.out == "141\n");
    CHECK(data.err.empty());
    // The same through a pipe that has a name.
    const ScratchFolder scratch;
    const std::string pipe = scratch / "pipe.json", few = name == "gvd-lloyd" ? "--iterations 1" : "";
    const std::string reader = "mkfifo " + pipe + "; { true < " + pipe + "; } & ";
    const CommandResult fifo = run_command("/bin/bash", "-c \"" + reader + command + data_file("torus.ply") +
                                                            " -n 400 -q " + few + " -o " + pipe + "; echo \\$?\"");
    CHECK(fifo.out == "141\n");
    CHECK_THAT(fifo.err, !Contains("error"));
  }
}

TEST_CASE("commands: closed streams are not taken by the files of the run") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const std::string arguments =
        data_file("torus.ply") + " -n 40 -o " + scratch / "a.off" + " --report " + scratch / "r.json";
    CHECK(run_command(name, arguments + " <&- >&- 2>&-").exit_code == 0);
    CHECK_THAT(read_text(scratch / "a.off"), !Contains(name));
    CHECK(nlohmann::json::parse(read_text(scratch / "r.json"))["command"] == name);
  }
}

TEST_CASE("commands: no binary goes to a terminal, but text does") {
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const auto shown = [&](const std::string& format) {
      return run_on_terminal(name, {data_file("torus.ply"), "-n", "40", "-q", "-o", "-", "--output-format", format});
    };
    for (const char* format : {"ply", "stl", "glb"}) {
      const CommandResult result = shown(format);
      CHECK(result.exit_code == 2);
      CHECK_THAT(result.err,
                 Contains(std::string("-o -: .") + format + " is binary, and standard output is a terminal"));
      CHECK(line_count(result.err) == 1);
    }
    CHECK_THAT(shown("off").err, StartsWith("OFF") || StartsWith("COFF"));
  }
}

TEST_CASE("commands: standard output carries data only, and standard input is read") {
  const std::string arguments = "- --input-format off -n 20 -o - < " + data_file("half_sphere.off");
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const CommandResult piped = run_command(name, arguments);
    CHECK(piped.exit_code == 0);
    CHECK(!piped.out.empty());
    CHECK(piped.out.find("gvd-") != 0);
    const CommandResult json = run_command(name, "--output-format json " + arguments);
    CHECK(nlohmann::json::parse(json.out).is_object());
  }
}

TEST_CASE("commands: a report goes to a pipe or a descriptor, whatever that is called") {
  const ScratchFolder scratch;
  const std::string run = data_file("torus.ply") + " -n 3 -q --report ";
  CHECK_THAT(run_command("gvd-segment", run + "/dev/stdout | cat").out, StartsWith("{\"schema\":\"gvd-report/2\""));
  CHECK(run_command("gvd-segment", run + "/dev/stdout > " + scratch / "out").exit_code == 0);
  CHECK_THAT(read_text(scratch / "out"), StartsWith("{\"schema\":"));
  CHECK_THAT(run_command("gvd-segment", run + "/dev/fd/3 3>&1 | cat").out, StartsWith("{\"schema\":"));
}

TEST_CASE("commands: a list of generators comes through a pipe, in any format") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("torus.ply"), made = mesh + " -n 12 -q --iterations 1 -o - ";
  for (const char* format : {"txt", "csv", "json"}) {
    CAPTURE(format);
    const CommandResult file =
        run_command("gvd-lloyd", made + "--output-format " + format + " > " + scratch / "list." + format);
    REQUIRE(file.exit_code == 0);
    const auto labels_of = [&](const std::string& arguments) {
      const CommandResult result = run_command("gvd-segment", mesh + " -q -o - " + arguments);
      CAPTURE(arguments, result.err);
      CHECK(result.exit_code == 0);
      return result.out;
    };
    const std::string list = scratch / "list." + format;
    const std::string expected = labels_of("--generators " + list);
    CHECK(labels_of("--generators - < " + list) == expected);
    const std::string same = std::string(format) == "txt" ? "text" : format;
    CHECK(labels_of("--generators - --generators-format " + same + " < " + list) == expected);
  }
  require_error("gvd-segment", mesh + " --generators - --generators-format json < " + scratch / "list.csv", 3,
                "standard input");
  require_error("gvd-segment", mesh + " --generators -", 3, "standard input:1: the list holds no generator");
  require_error("gvd-segment", "- --input-format obj --generators -", 2,
                "INPUT and --generators are both standard input");
  require_error("gvd-segment", mesh + " -n 3 --generators-format json", 2,
                "--generators-format needs --generators: add it");
  const std::string list = scratch / "list.json";
  require_error("gvd-segment", mesh + " --generators - --report " + list + " < " + list, 2, "the run reads this file");
}

TEST_CASE("commands: bars are drawn on a terminal only") {
  for (const std::string& name : built_commands()) {
    const std::vector<std::string> arguments{data_file("torus.ply"), "-n", "40"};
    const auto on_terminal = [&](const char* terminal, const char* no_color) {
      setenv("TERM", terminal, 1);
      setenv("NO_COLOR", no_color, 1);
      return run_on_terminal(name, arguments).err;
    };
    const std::string bar = "\r\x1b[K", colour = "\x1b[36m";
    const std::string with = on_terminal("xterm", "");
    CHECK_THAT(with, Contains(bar) && Contains(colour) && Contains("%"));
    CHECK_THAT(on_terminal("xterm", "1"), Contains(bar) && !Contains(colour));
    CHECK_THAT(on_terminal("dumb", ""), !Contains("\x1b"));
    CHECK_THAT(run_command(name, data_file("torus.ply") + " -n 40").err, !Contains("\r") && !Contains("\x1b"));
  }
}

TEST_CASE("commands: the bar of a relaxation has iteration and energy, and no last iteration that may not come") {
  setenv("TERM", "xterm", 1);
  const CommandResult result =
      run_on_terminal("gvd-lloyd", {data_file("figure.obj"), "-n", "40", "--iterations", "30", "--tolerance", "0"});
  CHECK_THAT(result.err, Contains("relaxation iteration ") && Contains(", energy ") && !Contains("/30"));
}

TEST_CASE("commands: an interrupted run exits with 130 and leaves the old file") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    for (const int signal : {SIGINT, SIGTERM}) {
      CAPTURE(name, signal);
      write_text(scratch / "old.json", "old");
      const CommandResult result =
          run_interrupted(name, {"-", "--input-format", "obj", "-n", "1", "-o", scratch / "old.json"}, signal);
      CHECK(result.exit_code == 130);
      CHECK(line_count(result.err) == 1);
      CHECK(read_text(scratch / "old.json") == "old");
    }
  }
}

TEST_CASE("commands: a pipe without a reader is waited for until the run is interrupted") {
  const ScratchFolder scratch;
  REQUIRE(std::system(("mkfifo " + scratch / "pipe.off").c_str()) == 0);
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const CommandResult result =
        run_interrupted(name, {data_file("torus.ply"), "-n", "9", "-q", "-o", scratch / "pipe.off"}, SIGINT);
    CHECK(result.exit_code == 130);
    CHECK(line_count(result.err) == 1);
  }
}

}  // namespace gvd::test_command_streams
