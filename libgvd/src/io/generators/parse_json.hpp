#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_list.hpp"

namespace gvd::detail {

/// A list as JSON: the array `generators` of any object, such as a diagram or a report.
/// `name` is the list's, for messages. Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_json(std::string_view content, const std::string& name);

}  // namespace gvd::detail
