#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gvd {

/// The numbers of a list in any locale, between blanks, commas and line ends; # begins a comment. `name` is the file's,
/// for messages. Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<double> parse_numbers(std::string_view content, const std::string& name);

/// Those of a file. Throws Error{unreadable_input} where it can't be read, or holds anything else.
std::vector<double> read_numbers(const std::filesystem::path& path);

}  // namespace gvd
