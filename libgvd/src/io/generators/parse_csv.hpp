#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_list.hpp"

namespace gvd::detail {

/// A list as comma-separated values: the fields of the text form, or named columns below a header.
/// `name` is the list's, for messages. Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_csv(std::string_view content, const std::string& name);

}  // namespace gvd::detail
