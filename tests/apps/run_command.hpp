#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/sanitized.hpp"

namespace gvd::test {

/// The outcome of a command.
struct CommandResult {
  int exit_code = -1;  ///< -1 where a signal ended it
  std::string out;
  std::string err;
};

/// Runs a built command, such as `gvd-segment`, through the shell. `arguments` may hold redirections.
/// Standard output and error are collected where the line does not redirect them.
CommandResult run_command(const std::string& name, const std::string& arguments);

/// Runs a built command with standard error on a terminal of 80 columns.
CommandResult run_on_terminal(const std::string& name, const std::vector<std::string>& arguments);

/// A run that was interrupted.
struct StoppedRun {
  CommandResult result;
  double seconds = -1;  ///< from the signal to the end of the process; below 0 where no signal was sent
};

/// Runs a built command with standard error on a terminal, and sends it SIGINT once its bar shows this step. `TERM`
/// must be such that bars are drawn.
StoppedRun interrupt_at(const std::string& step, const std::string& name, const std::vector<std::string>& arguments);

/// Runs a built command that waits for standard input, and sends it `signal` while it waits. Collects standard error.
CommandResult run_interrupted(const std::string& name, const std::vector<std::string>& arguments, int signal);

/// The commands, of the three that build diagrams, that this build has.
std::vector<std::string> built_commands();

/// A fresh folder that is removed with this object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// A path inside. It holds no blanks, so that a shell needs no quotes.
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);

/// A mesh of the repository's data folder.
std::string data_file(const std::string& name);

}  // namespace gvd::test
