#pragma once

#include <istream>
#include <string>
#include <vector>

#include "gvd/option_list.hpp"

namespace gvd::app {

/// The texts that a user gives for an option after its name (none if it stands alone), and where they come from.
struct GivenTexts {
  const Option* option;
  Given::Source source;
  std::vector<std::string> texts;
};

/// Whether the texts turn a flag off, which is the same as not giving it.
bool turns_off(const GivenTexts& given);

/// Reads the options of a TOML file in order, each value as it would be typed on a command line. A key is the name of
/// an option without its dashes; INPUT is `input`. `file`: its name, for places in messages.
///
/// Throws Error{invalid_option} with file, line, key and what was expected, if the file is no TOML, a key is no option,
/// two keys name the same option, or a value has a wrong type.
std::vector<GivenTexts> read_config_file(const OptionList& list, std::istream& input, const std::string& file);

/// Whether the command line overrides an option of the file. `typed`: the options of the line. It does if it
/// 1. gives the same option;
/// 2. has an option that excludes it: a file's `n` is ignored if the line has --vertices;
/// 3. leaves it without an option that it needs: a file's `up` is ignored if the line excludes `view`.
bool is_overridden(const OptionList& list, const Option& option, const std::vector<GivenTexts>& typed);

}  // namespace gvd::app
