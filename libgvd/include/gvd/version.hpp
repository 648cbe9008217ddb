#pragma once

#include <string_view>

namespace gvd {

/// The release of the library that a program runs with, as in "0.2.0": major, minor and patch.
std::string_view version();

}  // namespace gvd
