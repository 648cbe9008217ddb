#pragma once

namespace gvd::app {

/// From here on SIGINT and SIGTERM only raise a flag, once: a second one ends the process the usual way. A closed pipe
/// becomes a write error instead of a signal.
void install_signal_handlers();

bool interrupt_requested() noexcept;

/// Throws Error{interrupted} where a signal came. For the steps that report no progress.
void check_interrupt();

}  // namespace gvd::app
