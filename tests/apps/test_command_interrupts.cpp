// Interrupts of the commands at work: a signal in each long step ends the run soon, and no output is left behind.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "apps/run_command.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"
#include "support/simple_obj.hpp"

namespace gvd::test_command_interrupts {

using namespace test;
using Catch::Matchers::Contains;

/// Longest time from a signal to the end, seconds. Sanitizers take ten times as long.
constexpr double kSoon = kSanitized ? 20 : 2;

/// A folder with a torus of many faces, whose steps take seconds.
class Workplace {
 public:
  Workplace(int around, int across) {
    constexpr int kCoarser = kSanitized ? 4 : 1;
    setenv("TERM", "xterm", 1);
    write_simple_obj(scratch_ / "torus.obj", make_torus(around / kCoarser, across / kCoarser));
  }

  /// Interrupts a run with two outputs, of which one exists, at a step. It must end as the guide says.
  void require_interrupted(const std::string& step, const std::string& name, std::vector<std::string> arguments) const {
    CAPTURE(name, step, arguments);
    write_text(scratch_ / "old.json", "old");
    arguments.insert(arguments.begin(), scratch_ / "torus.obj");
    arguments.insert(arguments.end(), {"-o", scratch_ / "old.json", "--view", scratch_ / "new.html"});
    const StoppedRun stopped = interrupt_at(step, name, arguments);
    const std::string& err = stopped.result.err;
    CAPTURE(stopped.seconds, err.substr(err.size() - std::min<std::size_t>(err.size(), 200)));
    CHECK(stopped.seconds >= 0);  // the step came
    CHECK(stopped.seconds < kSoon);
    CHECK(stopped.result.exit_code == 130);
    CHECK_THAT(err, Contains(name + ": error: interrupted"));
    const std::string written = read_text(scratch_ / "old.json");  // whole, where the view comes after it
    CHECK((step == "view" ? nlohmann::json::accept(written) : written == "old"));
    CHECK(list_files() == std::vector<std::string>{"old.json", "torus.obj"});
  }

 private:
  std::vector<std::string> list_files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(scratch_ / ".")) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  ScratchFolder scratch_;
};

// The numbers of generators make these steps long: most take longer than kSoon to their end.

TEST_CASE("gvd-segment: an interrupt in each long step ends it soon, and no file is left half-written") {
  const Workplace workplace(500, 200);
  workplace.require_interrupted("sampling", "gvd-segment", {"-n", "50000"});
  workplace.require_interrupted("distances", "gvd-segment", {"-n", "2"});
  workplace.require_interrupted("borders", "gvd-segment", {"-n", "9000", "--sampling", "random"});
}

TEST_CASE("gvd-lloyd: an interrupt of the relaxation ends it soon, and no file is left half-written") {
  const Workplace workplace(500, 200);
  workplace.require_interrupted("relaxation", "gvd-lloyd", {"-n", "900", "--sampling", "random"});
  workplace.require_interrupted("relaxation", "gvd-lloyd", {"-n", "900", "--sampling", "random", "--coarse", "40000"});
}

TEST_CASE("gvd-remesh: an interrupt in each long step ends it soon, and no file is left half-written") {
  const Workplace workplace(300, 120);
  workplace.require_interrupted("relaxation", "gvd-remesh", {"--sampling", "random", "-n", "2000"});
  workplace.require_interrupted("fit", "gvd-remesh", {"--sampling", "random", "--relax", "none", "-n", "5000"});
  workplace.require_interrupted("view", "gvd-remesh", {"--sampling", "random", "--relax", "none", "-n", "300"});
}

// Shells start a process behind & without standard input and with SIGINT ignored; SIGTERM arrives.
TEST_CASE("commands: a signal ends a run that waits for a pipe at once, with 130 and nothing left behind") {
  const ScratchFolder scratch;
  const std::string pipe = scratch / "pipe", torus = scratch / "torus.obj";
  write_simple_obj(torus, make_torus(12, 8));
  REQUIRE(std::system(("mkfifo " + pipe).c_str()) == 0);
  // Signals are sent once the command handles them, and waits. `writer` holds the pipe open, and writes nothing.
  const auto interrupt = [&](const std::string& name, const std::string& arguments, const std::string& writer) {
    return run_command(
        name,
        arguments + " -o " + scratch / "out.ply" + " & run=$!\n" + writer +
            "while kill -0 $run && ! grep -q 'SigCgt:.*[1-9a-f]' /proc/$run/status; do sleep 0.1; done; sleep 0.5\n"
            "kill -TERM $run; wait $run; code=$?\n" +
            (writer.empty() ? "" : "kill $writer; wait $writer 2>/dev/null\n") + "exit $code");
  };
  const std::string holds_open = "sleep 60 > " + pipe + " & writer=$!\n";
  for (const std::string& writer : {std::string(), holds_open}) {
    std::vector<std::pair<std::string, std::string>> calls{{"gvd-segment", pipe + " -n 3"},
                                                           {"gvd-lloyd", pipe + " -n 3"},
                                                           {"gvd-remesh", pipe + " -n 30"},
                                                           {"gvd-distance", torus + " --from " + pipe},
                                                           {"gvd-segment", torus + " --generators " + pipe},
                                                           {"gvd-segment", torus + " -n 3 --within " + pipe},
                                                           {"gvd-lloyd", torus + " -n 3 --density " + pipe},
                                                           {"gvd-remesh", pipe + " -n 30 --carry"},
                                                           {"gvd-segment", torus + " -n 3 --config " + pipe}};
    for (const auto& [name, arguments] : calls) {
      CAPTURE(name, arguments, writer);
      const CommandResult result = interrupt(name, arguments, writer);
      CHECK(result.exit_code == 130);
      CHECK(result.err == name + ": error: interrupted; no file is left half-written\n");
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(scratch / ".")) {
    CHECK((entry.path().filename() == "pipe" || entry.path().filename() == "torus.obj"));
  }
}

}  // namespace gvd::test_command_interrupts
