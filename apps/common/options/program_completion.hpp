#pragma once

#include <string>
#include <vector>

namespace gvd::app {

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
