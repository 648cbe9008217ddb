#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gvd/option_list.hpp"

namespace gvd::app {

/// Everything that is said about each option: an array of objects with `name`, `names` (as typed), `group`, `kind`,
/// `value` (as help shows it), `choices`, `range` and `extensions` where they apply, `unit`, `default`, `summary`,
/// `help`, `main`, `repeatable`, `excludes` and `needs`.
nlohmann::ordered_json describe_options(const OptionList& list);

/// As text with the table of formats, for --print-options: an object with `options` and `formats`. Throws
/// std::logic_error where a rule or a text names what is no option.
std::string print_description(const OptionList& list);

}  // namespace gvd::app
