#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>

namespace gvd::app {

/// How a child process ended.
struct ChildEnd {
  int exit_code = 0;
  int signal = 0;      ///< that ended it; 0: none did, and `exit_code` holds
  std::string answer;  ///< what its work has written; less than that where a signal ended it
};

/// Runs `work` in a child process and waits for it. `work` returns the exit code, and may set the text that goes back.
/// What the child allocates, changes and counts ends with it. Signals that ask this process to end are passed on to it.
/// To be called before this process has threads: the child has the calling one only.
/// Throws Error{no_valid_result} where the system starts no process.
ChildEnd run_in_child(const std::function<int(std::string& answer)>& work);

}  // namespace gvd::app
