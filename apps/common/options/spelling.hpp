#pragma once

#include <string>
#include <vector>

#include "gvd/option_list.hpp"

// Options as a command line and a file of --config spell them.
namespace gvd::app {

/// A name of the description with dashes: "max-snap"; of a flag that is on by default, "no-refine".
std::string dashed_name(const Option& option);

/// The names that a user may type: "-n" and "--count", or "INPUT".
std::vector<std::string> typed_names(const Option& option);

/// The name by which messages call an option: the shortest one.
std::string usual_name(const Option& option);

/// The keys that a file may have for an option: typed names without dashes; "input" for INPUT. None for a question.
std::vector<std::string> file_keys(const Option& option);

/// A text with each placeholder as the user wrote the option: as on the command line, or for those that come from a
/// file as its key. One that is not given is spelled for the command line, or with `in_file` for the file.
std::string spell(const OptionList& list, const Given& given, const std::string& text, bool in_file = false);

/// The options whose texts come from a command line, for help: as `spell` with nothing given.
std::string spell(const OptionList& list, const std::string& text);

/// Throws Error{invalid_option} with the place of the option in a file, if it comes from one, and `hint` otherwise.
[[noreturn]] void refuse_option(const OptionList& list, const Given& given, const Problem& problem,
                                const std::string& hint = "");

}  // namespace gvd::app
