#pragma once

#include <string>

namespace gvd::app {

/// The message of an error for users of a command. libgvd knows no command line: its advice names its own fields, as in
/// "raise max_snap". Where a message ends so, it ends with the option that does it.
std::string name_options(std::string message);

}  // namespace gvd::app
