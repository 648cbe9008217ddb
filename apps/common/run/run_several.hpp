#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/run/run.hpp"

namespace gvd::app {

/// Runs `body` once for each of `runs`, each in a process of its own, and notes a table of the results. A run that
/// fails says why in a line, and the next one begins; only an interruption ends all. Returns the exit code of the first
/// run that failed, or 0.
int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body);

}  // namespace gvd::app
