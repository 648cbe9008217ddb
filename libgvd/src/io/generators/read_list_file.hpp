#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gvd::detail {

/// The content of a file that holds a list. `what` names its elements for messages: "generators".
/// Throws Error{unreadable_input}.
std::string read_list_file(const std::filesystem::path& path, std::string_view what);

}  // namespace gvd::detail
