#pragma once

#include <string_view>

namespace gvd {

/// The release of the library that the program is linked to, as major, minor and patch: "0.2.0".
std::string_view version();

}  // namespace gvd
