#pragma once

#include <functional>
#include <string>

#include "common/run/exit_code.hpp"
#include "common/run/result_table.hpp"
#include "common/run/run.hpp"

namespace gvd::app {

/// How one of several runs ended.
struct RunEnd {
  int exit_code = kDone;
  std::string summary;  ///< in a few words
  RunFigures figures;
};

/// Runs `body` in a child process: it has the whole memory that is allowed, and what ends it does not end the other
/// runs. Its error is one line on standard error, with the name of the input.
RunEnd run_apart(const std::string& command, const Options& options, const std::function<void(Run&)>& body);

}  // namespace gvd::app
