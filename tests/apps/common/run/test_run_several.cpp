#include <unistd.h>

#include <csignal>
#include <exception>

#include "apps/run_command.hpp"
#include "common/run/interrupt.hpp"
#include "common/run/run_several.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_run_several {

using namespace app;

std::vector<Options> quiet_runs(const std::vector<std::string>& inputs) {
  std::vector<Options> runs;
  for (const std::string& input : inputs) {
    runs.emplace_back().input.path = input;
    runs.back().quiet = true;
  }
  return runs;
}

TEST_CASE("a run that fails does not stop the others, and the first failure is the exit code") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const int code = run_several("gvd-test", quiet_runs({"a", "b", "c"}), [&](Run& run) {
    const std::string& input = run.options().input.path;
    gvd::test::write_text(scratch / input, input);
    if (input == "a") throw Error(ErrorCode::precondition, "a: refused by a test");
    if (input == "b") throw Error(ErrorCode::unreadable_input, "b: refused by a test");
  });
  for (const char* input : {"a", "b", "c"}) CHECK(gvd::test::read_text(scratch / input) == input);
  CHECK(code == 4);
  CHECK(run_several("gvd-test", quiet_runs({"a"}), [](Run&) {}) == 0);
}

TEST_CASE("what ends the process of a run does not end the others") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const auto end_early = [&](Run& run) {
    const std::string& input = run.options().input.path;
    if (input == "killed") std::raise(SIGKILL);
    if (input == "terminated") std::terminate();
    gvd::test::write_text(scratch / input, input);
  };
  CHECK(run_several("gvd-test", quiet_runs({"killed", "terminated", "last"}), end_early) == 5);
  CHECK(gvd::test::read_text(scratch / "last") == "last");
}

TEST_CASE("memory that a run keeps is not held against the next one") {
  install_signal_handlers();
  constexpr std::size_t kKept = std::size_t{70} << 20;
  std::vector<Options> runs = quiet_runs({"a", "b", "c"});
  for (Options& options : runs) options.compute.max_memory = peak_memory_bytes() + (100 << 20);
  std::vector<std::string> kept;
  CHECK(run_several("gvd-test", runs, [&](Run& run) {
          kept.emplace_back(kKept, 'x');
          run.timed("look at the memory", [] {});
        }) == 0);
  CHECK(kept.empty());
}

TEST_CASE("an interruption ends all runs") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const int code = run_several("gvd-test", quiet_runs({"a", "b"}), [&](Run& run) {
    gvd::test::write_text(scratch / run.options().input.path, "seen");
    ::kill(::getppid(), SIGINT);  // this process gets it from its parent
    while (!interrupt_requested()) {
    }
    check_interrupt();
  });
  CHECK(code == 130);
  CHECK(gvd::test::read_text(scratch / "a") == "seen");
  CHECK(gvd::test::read_text(scratch / "b").empty());
  install_signal_handlers();
}

TEST_CASE("runs that an interruption leaves out are not done, even if the last one was") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const int code = run_several("gvd-test", quiet_runs({"a", "b"}), [&](Run& run) {
    gvd::test::write_text(scratch / run.options().input.path, "seen");
    ::kill(::getppid(), SIGINT);
    while (!interrupt_requested()) {
    }
  });
  CHECK(code == 130);
  CHECK(gvd::test::read_text(scratch / "b").empty());
  install_signal_handlers();
}

}  // namespace gvd::test_run_several
