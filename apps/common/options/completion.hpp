#pragma once

#include <string>
#include <vector>

#include "gvd/option_list.hpp"

namespace gvd::app {

/// A script that completes the command line of `command` in a shell: bash, zsh or fish. It has every option that --help
/// lists, with the words and the kinds of files that each one takes, and meshes for INPUT. Without the last line break.
/// Precondition: no word and no name holds a blank or a character that a shell expands.
std::string make_completion(const std::string& command, const OptionList& list, const std::string& shell);

/// A command of the program, as completion offers it.
struct CompletedCommand {
  std::string name;         ///< "segment"; the command's own script completes "gvd-segment"
  std::string description;  ///< one sentence
  std::string script;       ///< of `make_completion` for the same shell
};

/// A script that completes the command line of the program gvd in a shell, bash, zsh or fish: the names of commands,
/// and behind one what its own script offers. It completes gvd-segment and the like, too. Without the last line break.
/// Precondition: no description holds a quote or a backslash.
std::string make_program_completion(const std::vector<CompletedCommand>& commands, const std::string& shell);

}  // namespace gvd::app
