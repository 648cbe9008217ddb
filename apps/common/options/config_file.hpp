#pragma once

#include <istream>
#include <string>
#include <vector>

#include "gvd/option_list.hpp"

namespace gvd::app {

/// What a user gives for an option: the texts that follow its name, none where it stands alone, and where.
struct GivenTexts {
  const Option* option;
  Given::Source source;
  std::vector<std::string> texts;
};

/// Whether texts turn a flag off, which is as good as not giving it.
bool turns_off(const GivenTexts& given);

/// The options that a TOML file gives, in its order, each value as it would be typed on a command line. A key is a name
/// of an option without its dashes; INPUT is `input`. `file`: its name, for places.
///
/// Throws Error{invalid_option} with file, line, key and what was expected: where it is no TOML, a key is no option,
/// two keys name one option, or a value has a wrong type.
std::vector<GivenTexts> read_config_file(const OptionList& list, std::istream& input, const std::string& file);

/// Whether the command line takes the place of an option of the file. `typed`: what the line has. It does where it
/// 1. gives the same option;
/// 2. has one that excludes it: a file's `n` goes where the line has --vertices;
/// 3. leaves it without an option that it needs: a file's `up` goes where the line excludes `view`.
bool is_overridden(const OptionList& list, const Option& option, const std::vector<GivenTexts>& typed);

}  // namespace gvd::app
