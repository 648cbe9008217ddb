#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "common/options/options.hpp"

// The end of a run: its exit code and its message.
namespace gvd::app {

/// The exit codes of the commands, as docs/guide/commands.md lists them.
inline constexpr int kDone = 0;
inline constexpr int kUsage = 2;
inline constexpr int kUnreadableInput = 3;
inline constexpr int kPreconditionNotMet = 4;
inline constexpr int kNoResult = 5;
inline constexpr int kNotWritten = 6;
inline constexpr int kInterrupted = 130;  ///< what shells give for SIGINT
inline constexpr int kReaderGone = 141;   ///< what shells give for SIGPIPE

struct Outcome {
  int exit_code = kDone;
  std::string message;           ///< of its error, for users of a command; empty where there is none
  std::string summary = "done";  ///< in a few words: "unreadable input"
};

/// Runs `work`, and turns what it throws into an outcome: exit code 2 to 6, 130 or 141 for a gvd::Error of each code, 5
/// where memory runs out or a thread can't be started. A reader of the output that is gone has no message: nobody is
/// left to tell. Messages spell options as the user of the command does, by the list of `options`, if these are there.
/// Lifts the limit of memory at the end.
Outcome run_guarded(const std::function<void()>& work, const Options* options = nullptr);

/// Does the work of a process, which gives its exit code: readies streams and signals before, and ends as `run_guarded`
/// says, with the message in one line on standard error. `name` begins the line: "gvd-segment".
int run_process(const std::string& name, const std::function<int()>& work, const Options* options = nullptr);

/// Limits the memory of the run that begins, by its options (--max-memory). Messages of a shortage tell the limit, and
/// what helps.
void limit_memory_of(const Options& options);

/// "1.5 GiB".
std::string format_bytes(std::int64_t bytes);

/// From now on std::terminate ends the process with one line on standard error and an exit code, as `run_guarded`
/// would, instead of a signal. Functions that may not throw, such as destructors and threads of libraries, call it
/// where they are refused memory. `command` begins the line: "gvd-segment". `input`: that of one of several runs.
void report_termination(const std::string& command, const std::string& input = "");

}  // namespace gvd::app
