#pragma once

namespace gvd::app {

/// From now on the first SIGINT or SIGTERM only sets a flag; the second one ends the process. A write to a closed pipe,
/// or beyond the largest file that is allowed, becomes an error instead of a signal. Clears the flag.
void install_signal_handlers();

/// Whether the flag is set.
bool interrupt_requested() noexcept;

/// Throws Error{interrupted} where the flag is set. For steps without progress.
void check_interrupt();

}  // namespace gvd::app
