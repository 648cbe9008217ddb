#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/options/help.hpp"
#include "common/options/options.hpp"
#include "gvd/option_list.hpp"

namespace gvd::app {

/// Describes the options that every command has, as the last group.
void describe(OptionList& list, GeneralOptions& options);

/// Reads a command line and the file of --config into the fields of the options, and into `given`. The command line
/// takes precedence over the file (see `is_overridden`); options of the file that have no effect together with values
/// of the command line are dropped, too. `list` must have the general options. `words` does not include the command's
/// name.
///
/// Returns the answer to a question, such as the text of --help, or nothing.
/// Throws Error{invalid_option} with one line: the option as the user wrote it, what is wrong and what to do. For an
/// option from a file, the line begins with file, line and column.
std::optional<std::string> parse_command_line(const CommandInfo& command, const OptionList& list, Given& given,
                                              const std::vector<std::string>& words);

}  // namespace gvd::app
