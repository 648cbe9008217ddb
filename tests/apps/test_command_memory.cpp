// Where memory ends: by --max-memory, and by a limit of the system.

#include <filesystem>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_command_memory {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("memory: a run that passes --max-memory ends in one line, and writes nothing") {
  const ScratchFolder scratch;
  // Some 80 MB with fine bisectors, and 10 MB before the first diagram.
  const std::string mesh = data_file("figure.obj") + " -n 200 -q --chord-tolerance 1e-9 ";
  write_text(scratch / "o.toml", "max-memory = \"30M\"\n");
  for (const std::string& name : built_commands()) {
    require_error(name, mesh + "--max-memory much", 2, "'much' is not a size");
    if (kSanitized) continue;
    for (const std::string& limit : std::vector<std::string>{
             "--max-memory 1K", "--max-memory 30M", "--threads 4 --max-memory 30M", "--config " + scratch / "o.toml"}) {
      const std::string told = limit.starts_with("--config") ? "max-memory = \"30 MiB\"; raise it" : "--max-memory ";
      require_error(name, mesh + limit + " -o " + scratch / "a.ply", 5,
                    "out of memory: the run needs more than " + told);
    }
    CHECK(!std::filesystem::exists(scratch / "a.ply"));
    CHECK(run_command(name, data_file("torus.ply") + " -n 20 -q --max-memory 2G -o " + scratch / "a.ply").exit_code ==
          0);
    std::filesystem::remove(scratch / "a.ply");
  }
}

TEST_CASE("memory: a list of generators that does not fit is refused, and never cut short") {
  if (kSanitized) return;
  const ScratchFolder scratch;
  write_text(scratch / "long.txt", "0\n" + std::string(std::size_t{20} << 20, '#') + "\n1\n");
  const std::string run = data_file("torus.ply") + " -q -o " + scratch / "a.ply --generators ";
  require_error("gvd-segment", run + scratch / "long.txt --max-memory 30M", 5, "out of memory: ");
  require_error("gvd-segment", run + "- --generators-format text --max-memory 30M < " + scratch / "long.txt", 5,
                "out of memory: ");
}

TEST_CASE("memory: where the system has no more, the message says how much was in use") {
  if (kSanitized) return;  // they reserve more than there is
  for (const std::string& name : built_commands()) {
    const std::string run = "ulimit -v 90000; exec '" + std::string(GVD_BIN_DIR) + "/" + name + "' " +
                            data_file("figure.obj") + " -n 200 -q --threads 1 --chord-tolerance 1e-9";
    const CommandResult result = run_command("/bin/sh", "-c \"" + run + "\"");
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 5);
    CHECK(line_count(result.err) == 1);
    CHECK_THAT(result.err, StartsWith(name + ": error: out of memory: up to ") && Contains(" in use; ") &&
                               Contains("use --max-memory to stop such a run earlier"));
  }
}

TEST_CASE("memory: of several inputs each has the whole limit") {
  if (kSanitized) return;
  const ScratchFolder scratch;
  // The first one needs some 80 MB, the second one 10.
  const CommandResult result =
      run_command("gvd-segment", data_file("figure.obj") + " " + data_file("torus.ply") +
                                     " -n 200 --chord-tolerance 1e-9 --max-memory 30M --output-dir " + scratch / "out");
  CAPTURE(result.err);
  CHECK(result.exit_code == 5);
  CHECK_THAT(result.err, Contains("figure.obj  failed (5: out of memory)"));
  CHECK_THAT(result.err, Contains("torus.ply   done"));
}

TEST_CASE(
    "memory: where it ends before a message or a thread has some, there is a line and an exit code all the same") {
  if (kSanitized) return;  // they reserve more than there is
  const ScratchFolder scratch;
  int told = 0;
  for (int kilobytes = 11000; kilobytes <= 20000; kilobytes += 300) {
    const std::string run = "ulimit -v " + std::to_string(kilobytes) + "; exec '" + GVD_BIN_DIR + "/gvd-remesh' " +
                            data_file("figure.obj") + " -n 20 -q --threads 2 -o " + scratch / "a.ply";
    const CommandResult result = run_command("/bin/sh", "-c \"" + run + "\"");
    CAPTURE(kilobytes, result.err);
    if (result.exit_code == 127 || result.exit_code == 0) continue;  // the libraries do not fit, or the run does
    if (result.err.starts_with("terminate called")) continue;        // their constants do not, before main() has a say
    CHECK(result.exit_code == 5);
    CHECK_THAT(result.err, StartsWith("gvd-remesh: error: ") && !Contains("unexpected"));
    CHECK(line_count(result.err) == 1);
    CHECK(!std::filesystem::exists(scratch / "a.ply.partial0"));
    ++told;
  }
  CHECK(told > 0);
}

}  // namespace gvd::test_command_memory
