#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "common/run/child_process.hpp"
#include "common/run/interrupt.hpp"
#include "support/catch.hpp"

namespace gvd::test_child_process {

using namespace app;

TEST_CASE("a child process gives its exit code and its answer, and keeps what it changes") {
  int changed = 0;
  const std::string much(1 << 20, 'x');  // more than a pipe holds
  const ChildEnd end = run_in_child([&](std::string& answer) {
    changed = 1;
    answer = much;
    return 6;
  });
  CHECK(end.exit_code == 6);
  CHECK(end.signal == 0);
  CHECK(end.answer == much);
  CHECK(changed == 0);
}

TEST_CASE("a child's exit code is known where the caller ignores the end of children") {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const ChildEnd end = run_in_child([](std::string&) { return 3; });
  std::signal(SIGCHLD, before);
  CHECK(end.exit_code == 3);
}

TEST_CASE("a child process that a signal ends gives the signal") {
  const ChildEnd end = run_in_child([](std::string&) {
    std::raise(SIGKILL);
    return 0;
  });
  CHECK(end.signal == SIGKILL);
  CHECK(end.answer.empty());
}

TEST_CASE("a signal that asks this process to end is passed on to its child") {
  install_signal_handlers();
  const ChildEnd end = run_in_child([](std::string& answer) {
    ::kill(::getppid(), SIGINT);
    while (!interrupt_requested()) {
    }
    answer = "asked";
    return 130;
  });
  CHECK(end.exit_code == 130);
  CHECK(end.answer == "asked");
  install_signal_handlers();
}

}  // namespace gvd::test_child_process
