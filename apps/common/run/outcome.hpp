#pragma once

#include <exception>
#include <functional>
#include <string>

#include "common/run/exit_code.hpp"

namespace gvd::app {

/// How a run ended.
struct Outcome {
  int exit_code = kDone;
  std::string message;           ///< of its error, for users of a command; empty where there is none
  std::string summary = "done";  ///< in a few words: "unreadable input"
};

/// Runs `work`, and turns what it throws into an outcome: exit code 2 to 6, 130 or 141 for a gvd::Error of each code, 5
/// where memory runs out or a thread can't be started. A reader of the output that is gone has no message: nobody is
/// left to tell.
Outcome run_guarded(const std::function<void()>& work);

/// The outcome of a run that ended with this exception. Null: it ended without one, as std::terminate may.
Outcome describe_failure(const std::exception_ptr& failure);

}  // namespace gvd::app
