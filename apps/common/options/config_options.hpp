#pragma once

#include <deque>
#include <vector>

#include "common/options/config_file.hpp"
#include "common/options/option_text.hpp"

namespace gvd::app {

/// The options that the entries of a file name. A key is a name of an option without its dashes; "INPUT" is `input`.
/// Throws Error{invalid_option} with file, line, key and what was expected. Causes: a key is no option, two keys name
/// one option, or a value has a wrong type.
std::vector<GivenOption> find_config_options(const std::vector<ConfigEntry>& entries,
                                             const std::deque<DeclaredOption>& declared);

}  // namespace gvd::app
