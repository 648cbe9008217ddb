#pragma once

#include <string>
#include <vector>

#include "gvd/option_list.hpp"

// Spells options as on a command line and in a file of --config.
namespace gvd::app {

/// The name of an option with dashes: "max-snap", or "no-refine" for a flag that is on by default.
std::string dashed_name(const Option& option);

/// The names that a user may type: "-n" and "--count", or "INPUT".
std::vector<std::string> typed_names(const Option& option);

/// The name by which messages call an option: the shortest one.
std::string usual_name(const Option& option);

/// The keys of an option in a file: its typed names without dashes, and "input" for INPUT. A question has none.
std::vector<std::string> file_keys(const Option& option);

/// Replaces the placeholders of a text by options as the user wrote them, on the command line or as a key in the file.
/// An option that is not given is spelled as on the command line or, with `in_file`, as in the file.
std::string spell(const OptionList& list, const Given& given, const std::string& text, bool in_file = false);

/// The same with no option given, for help.
std::string spell(const OptionList& list, const std::string& text);

/// Throws Error{invalid_option} with the option's place in the file if it comes from a file, and otherwise with `hint`.
[[noreturn]] void refuse_option(const OptionList& list, const Given& given, const Problem& problem,
                                const std::string& hint = "");

}  // namespace gvd::app
