#pragma once

#include <string>
#include <vector>

#include "gvd/option_list.hpp"

namespace gvd::app {

/// Makes a script that completes the command line of `command` in a shell (bash, zsh or fish). It offers every option
/// that --help lists, the words and kinds of files that each option takes, and meshes for INPUT. The script does not
/// end in a line break. Precondition: no word and no name contains a blank or a character that a shell expands.
std::string make_completion(const std::string& command, const OptionList& list, const std::string& shell);

/// A command of the program, as completion offers it.
struct CompletedCommand {
  std::string name;         ///< "segment"; the command's own script completes "gvd-segment"
  std::string description;  ///< one sentence
  std::string script;       ///< of `make_completion` for the same shell
};

/// Makes a script that completes the command line of the program gvd in a shell (bash, zsh or fish): the names of
/// commands, and after a name the same as the command's own script. It completes gvd-segment and the like, too. The
/// script does not end in a line break. Precondition: no description contains a quote or a backslash.
std::string make_program_completion(const std::vector<CompletedCommand>& commands, const std::string& shell);

}  // namespace gvd::app
