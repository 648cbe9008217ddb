#include <csignal>

#include "apps/run_command.hpp"
#include "common/run/interrupt.hpp"
#include "common/run/run_several.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::app;

namespace {

std::vector<Options> quiet_runs(const std::vector<std::string>& inputs) {
  std::vector<Options> runs;
  for (const std::string& input : inputs) {
    runs.emplace_back().input.path = input;
    runs.back().quiet = true;
  }
  return runs;
}

}  // namespace

TEST_CASE("a run that fails does not stop the others, and the first failure is the exit code") {
  install_signal_handlers();
  std::vector<std::string> seen;
  const int code = run_several("gvd-test", quiet_runs({"a", "b", "c"}), [&](Run& run) {
    seen.push_back(run.options().input.path);
    if (seen.back() == "a") throw Error(ErrorCode::precondition, "a: refused by a test");
    if (seen.back() == "b") throw Error(ErrorCode::unreadable_input, "b: refused by a test");
  });
  CHECK(seen == std::vector<std::string>{"a", "b", "c"});
  CHECK(code == 4);
  CHECK(run_several("gvd-test", quiet_runs({"a"}), [](Run&) {}) == 0);
}

TEST_CASE("an interruption ends all runs") {
  install_signal_handlers();
  int runs = 0;
  const int code = run_several("gvd-test", quiet_runs({"a", "b"}), [&](Run&) {
    ++runs;
    std::raise(SIGINT);
    check_interrupt();
  });
  CHECK(runs == 1);
  CHECK(code == 130);
  install_signal_handlers();
}
