#pragma once

#include <string>

namespace gvd::app {

/// From now on std::terminate ends the process with one line on standard error and an exit code, as `run_guarded`
/// would, instead of a signal. Functions that may not throw, such as destructors and threads of libraries, call it
/// where they are refused memory. `command` begins the line: "gvd-segment". `input`: that of one of several runs.
void report_termination(const std::string& command, const std::string& input = "");

}  // namespace gvd::app
