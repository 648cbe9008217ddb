#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/options/help.hpp"
#include "common/options/options.hpp"
#include "gvd/option_list.hpp"

namespace gvd::app {

/// Describes the options that every command has; they are the last group.
void describe(OptionList& list, GeneralOptions& options);

/// Reads a command line and the file of --config into the fields of the options, and `given`. The command line goes
/// before the file: see `is_overridden`. An option of the file that does nothing beside a value of the line is left
/// out, too. `list` has the general options. `words`: without the command's name.
///
/// Returns the answer to a question, such as the text of --help, or nothing.
/// Throws Error{invalid_option} in one line: the option as the user wrote it, what is wrong and what to do; in front of
/// it file, line and column, where it comes from a file.
std::optional<std::string> parse_command_line(const CommandInfo& command, const OptionList& list, Given& given,
                                              const std::vector<std::string>& words);

}  // namespace gvd::app
