#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_list.hpp"

namespace gvd::detail {

/// A list as text, one entry a line: `V`, `F b0 b1 b2`, `p x y z` or `x y z`; # starts a comment.
/// `name` is the list's, for messages. Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_text(std::string_view content, const std::string& name);

}  // namespace gvd::detail
