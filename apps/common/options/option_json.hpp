#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gvd/option_list.hpp"

namespace gvd::app {

/// The full description of each option: an array of objects with `name`, `names` (as typed), `group`, `kind`, `value`
/// (as help shows it), `choices`, `range` and `extensions` where they apply, `unit`, `default`, `summary`, `help`,
/// `main`, `repeatable`, `excludes` and `needs`.
nlohmann::ordered_json describe_options(const OptionList& list);

/// The descriptions with the table of formats as text, for --print-options: an object with `options` and `formats`.
/// Throws std::logic_error if a rule or a text names an unknown option.
std::string print_description(const OptionList& list);

}  // namespace gvd::app
