#pragma once

#include <string>

namespace gvd::app {

/// The name of standard input in messages.
inline constexpr const char* kStandardInput = "standard input";

/// All that standard input holds. Throws Error{unreadable_input}, and Error{interrupted} after a signal.
std::string read_standard_input();

}  // namespace gvd::app
