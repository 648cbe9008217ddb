#pragma once

#include <functional>
#include <string>

namespace gvd::app {

/// How a run ended.
struct Outcome {
  int exit_code = 0;
  std::string message;           ///< of its error, for users of a command; empty where there is none
  std::string summary = "done";  ///< in a few words: "unreadable input"
};

/// The exit code that stands for SIGPIPE in shells.
inline constexpr int kReaderGone = 141;

/// Runs `work`, and turns what it throws into an outcome: exit code 2 to 6, 130 or 141 for a gvd::Error of each code, 5
/// where memory runs out. A reader of the output that is gone has no message: nobody is left to tell.
Outcome run_guarded(const std::function<void()>& work);

}  // namespace gvd::app
