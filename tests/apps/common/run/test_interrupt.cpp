#include <csignal>

#include "common/run/interrupt.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_interrupt {

using namespace app;

TEST_CASE("a signal raises the flag, and installing the handlers clears it") {
  for (const int signal : {SIGINT, SIGTERM}) {
    install_signal_handlers();
    CHECK(!interrupt_requested());
    CHECK_NOTHROW(check_interrupt());
    std::raise(signal);
    CHECK(interrupt_requested());
    try {
      check_interrupt();
      FAIL("no error");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::interrupted);
    }
  }
  install_signal_handlers();
  CHECK(!interrupt_requested());
}

TEST_CASE("a closed pipe raises no flag and ends nothing") {
  install_signal_handlers();
  std::raise(SIGPIPE);
  CHECK(!interrupt_requested());
}

TEST_CASE("a second signal has its usual effect") {
  install_signal_handlers();
  std::raise(SIGTERM);
  struct sigaction now {};
  REQUIRE(sigaction(SIGTERM, nullptr, &now) == 0);
  CHECK(now.sa_handler == SIG_DFL);
  install_signal_handlers();
}

}  // namespace gvd::test_interrupt
