#pragma once

#include <string>

#include "gvd/option_list.hpp"

namespace gvd::app {

/// A script that completes the command line of `command` in a shell: bash, zsh or fish. It has every option that --help
/// lists, with the words and the kinds of files that each one takes, and meshes for INPUT. Without the last line break.
/// Precondition: no word and no name holds a blank or a character that a shell expands.
std::string make_completion(const std::string& command, const OptionList& list, const std::string& shell);

}  // namespace gvd::app
