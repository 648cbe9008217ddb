#include "common/run/interrupt.hpp"

#include <csignal>

#include "gvd/error.hpp"

namespace gvd::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void raise_flag(int) { interrupted = 1; }

}  // namespace

void install_signal_handlers() {
  interrupted = 0;
  struct sigaction once {};
  once.sa_handler = raise_flag;
  once.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&once.sa_mask);
  sigaction(SIGINT, &once, nullptr);
  sigaction(SIGTERM, &once, nullptr);
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

bool interrupt_requested() noexcept { return interrupted != 0; }

void check_interrupt() {
  if (interrupt_requested()) throw Error(ErrorCode::interrupted, "interrupted; no file is left half-written");
}

}  // namespace gvd::app
