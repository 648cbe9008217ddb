#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "common/options/options.hpp"

// The outcome of a run: its exit code and its message.
namespace gvd::app {

/// The exit codes of the commands, as docs/guide/commands.md lists them.
inline constexpr int kDone = 0;
inline constexpr int kUsage = 2;
inline constexpr int kUnreadableInput = 3;
inline constexpr int kPreconditionNotMet = 4;
inline constexpr int kNoResult = 5;
inline constexpr int kNotWritten = 6;
inline constexpr int kInterrupted = 130;  ///< the exit code that shells report for SIGINT
inline constexpr int kReaderGone = 141;   ///< the exit code that shells report for SIGPIPE

struct Outcome {
  int exit_code = kDone;
  std::string message;           ///< the message of its error, for users of the command; empty if there is none
  std::string summary = "done";  ///< in a few words, such as "unreadable input"
};

/// Runs `work`, and turns an exception into an outcome: exit code 2 to 6, 130 or 141 for the codes of gvd::Error, and 5
/// if memory runs out or a thread can't be started. If the reader of the output is gone there is no message, because
/// nobody would read it. With `options`, messages spell options as the user of the command does. Lifts the memory limit
/// at the end.
Outcome run_guarded(const std::function<void()>& work, const Options* options = nullptr);

/// Runs the work of a process, which returns its exit code. Prepares streams and signals first, and handles exceptions
/// as `run_guarded` does, with the message in one line on standard error. The line begins with `name`, such as
/// "gvd-segment".
int run_process(const std::string& name, const std::function<int()>& work, const Options* options = nullptr);

/// Limits the memory of a run by its options (--max-memory). Messages about a lack of memory name the limit and say
/// what helps.
void limit_memory_of(const Options& options);

/// Formats a size, such as "1.5 GiB".
std::string format_bytes(std::int64_t bytes);

/// From now on std::terminate ends the process with one line on standard error and an exit code, as `run_guarded`
/// would, instead of with a signal. Functions that may not throw, such as destructors and threads of libraries, call it
/// when they get no memory. The line begins with `command`, such as "gvd-segment". `input`: the input, if there are
/// several runs.
void report_termination(const std::string& command, const std::string& input = "");

}  // namespace gvd::app
