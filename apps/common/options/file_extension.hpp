#pragma once

#include <string>

namespace gvd::app {

/// The extension of `path` in lower case, without its dot; empty where it has none.
std::string file_extension(const std::string& path);

}  // namespace gvd::app
