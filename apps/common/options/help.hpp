#pragma once

#include <cstddef>
#include <string>

#include "common/options/check_options.hpp"
#include "gvd/option_list.hpp"

namespace gvd::app {

/// The name and the texts of a command.
struct CommandInfo {
  std::string name;            ///< "gvd-segment"
  std::string description;     ///< one sentence
  std::string examples;        ///< for --help, one call on each line
  OutputFormats formats = {};  ///< the formats of -o
};

/// The text of --help after the options, with these examples.
std::string help_footer(const std::string& examples);

/// The text of --help: all options in their groups. No line is longer than 80 columns unless a single word is.
std::string make_help(const CommandInfo& command, const OptionList& list);

/// The text of -h: the main options, each with only its first line.
std::string make_short_help(const CommandInfo& command, const OptionList& list);

/// The full description of an option as in --help, with its unit and its default.
std::string describe_in_full(const OptionList& list, const Option& option);

/// Wraps `text` into lines of at most `width` columns. All lines except the first begin with `indent` blanks.
std::string wrap(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace gvd::app
