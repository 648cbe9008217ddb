#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "common/options/check_options.hpp"
#include "common/options/command_line.hpp"
#include "common/options/options.hpp"
#include "common/options/register_options.hpp"
#include "common/run.hpp"

namespace gvd::app {

struct CommandInfo {
  std::string name;         ///< "gvd-segment"
  std::string description;  ///< one sentence
  std::string examples;     ///< for --help: one call a line
  OutputFormats formats;    ///< `-o -` writes the first one unless --output-format names another
  decltype(&register_options) register_shared = register_options;
};

/// A command: the shared options, its own options, and the way from main() to an exit code.
///
///     bool cut = false;
///     Command command({"gvd-segment", "Labels ...", "  gvd-segment a.obj -n 30 -o b.ply\n", {{"ply", "obj"}}});
///     add_flag(command.line(), "--cut", cut, "Split faces along the bisectors");
///     return command.run(argc, argv, [&](Run& run) { segment(run, cut); });
class Command {
 public:
  explicit Command(CommandInfo info);
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  /// For the command's own options. A check of several of them belongs in `body`, as Error{invalid_option}.
  CLI::App& line() { return line_; }
  /// The shared options, which the command's own ones may add to.
  Options& options() { return options_; }

  /// Adds an option that names a further file of the command: `output.own["--stats"]` of the run's options. It is
  /// checked as the files of all commands are, with the extensions of `side_extensions`.
  void add_target(const std::string& name, const std::string& description);

  /// From now on, a run for which no file is named writes to standard output, as with -o -. `choose_format` is called
  /// where --output-format does not name one.
  void print_results(std::function<std::string()> choose_format);

  /// Parses, runs `body` and returns the exit code: 0 where it returns, or else that of `run_guarded`, with its message
  /// in one line on standard error. With --output-dir, runs `body` once for each input: see `run_several`.
  int run(int argc, const char* const* argv, const std::function<void(Run&)>& body);

 private:
  /// Sets the outputs that follow from the absence of others.
  void complete_options();

  CommandInfo info_;
  Options options_;
  CLI::App line_;
  std::vector<ValueRule> rules_;
  std::function<std::string()> choose_format_;  // empty: nothing is printed unless -o - asks for it
};

}  // namespace gvd::app
