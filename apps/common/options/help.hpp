#pragma once

#include <cstddef>
#include <string>

#include "common/options/check_options.hpp"
#include "gvd/option_list.hpp"

namespace gvd::app {

/// What a command says about itself.
struct CommandInfo {
  std::string name;            ///< "gvd-segment"
  std::string description;     ///< one sentence
  std::string examples;        ///< for --help: one call a line
  OutputFormats formats = {};  ///< of -o
};

/// What --help says behind the options, with these examples.
std::string help_footer(const std::string& examples);

/// The text of --help: all options in their groups. No line is longer than 80 columns, as long as no single word is.
std::string make_help(const CommandInfo& command, const OptionList& list);

/// The text of -h: the main options, each with its first line alone.
std::string make_short_help(const CommandInfo& command, const OptionList& list);

/// What an option does, in full, as --help has it: with its unit and its default.
std::string describe_in_full(const OptionList& list, const Option& option);

/// The words of `text` in lines of at most `width` columns, all but the first one after `indent` blanks.
std::string wrap(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace gvd::app
