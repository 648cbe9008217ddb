#pragma once

namespace gvd::app {

/// The exit codes of the commands, as docs/guide/commands.md lists them.
enum ExitCode : int {
  kDone = 0,
  kUsage = 2,
  kUnreadableInput = 3,
  kPreconditionNotMet = 4,
  kNoResult = 5,
  kNotWritten = 6,
  kInterrupted = 130,  ///< what shells give for SIGINT
  kReaderGone = 141,   ///< what shells give for SIGPIPE
};

}  // namespace gvd::app
