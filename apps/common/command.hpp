#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/options/check_options.hpp"
#include "common/options/options.hpp"
#include "common/outcome.hpp"
#include "common/run.hpp"
#include "gvd/option_list.hpp"

namespace gvd::app {

struct CommandInfo {
  std::string name;         ///< "gvd-segment"
  std::string description;  ///< one sentence
  std::string examples;     ///< for --help: one call a line
  OutputFormats formats;    ///< of -o
};

/// What a command is, of options in a struct that inherits Options.
template <class OwnOptions>
struct CommandSteps {
  void (*describe)(OptionList& list, OwnOptions& options);
  /// What one run does. The options are its own: what it changes of them is what the report tells.
  void (*run)(Run& run, OwnOptions& options);
  /// Sets what follows from the options that were given, before they are checked. May be null.
  void (*complete)(OwnOptions& options, const Given& given) = nullptr;
};

/// What --help says behind the options, with these examples.
std::string help_footer(const std::string& examples);

/// The frame of a command, of options that `list` describes; for `run_command`.
int run_described(const CommandInfo& info, OptionList& list, Options& options, int argc, const char* const* argv,
                  const std::function<void(const Given&)>& complete, const std::function<void(Run&)>& body);

/// Reads the options and runs the command, with --output-dir once for each input: see `run_several`. Returns the exit
/// code: 0 where all goes well, or else that of `run_guarded`, with its message in one line on standard error.
template <class OwnOptions>
int run_command(const CommandInfo& info, const CommandSteps<OwnOptions>& steps, int argc, const char* const* argv) {
  report_termination(info.name);  // options may not find the memory that they need
  const auto options = std::make_unique<OwnOptions>();
  OptionList list;
  steps.describe(list, *options);
  std::optional<OwnOptions> given;  // of all runs, before the first one
  const auto complete = [&](const Given& names) {
    if (steps.complete != nullptr) steps.complete(*options, names);
  };
  return run_described(info, list, *options, argc, argv, complete, [&](Run& run) {
    if (given) *options = *given;
    if (!given) given = *options;
    options->input = run.options().input;
    options->output = run.options().output;
    run.follow(*options);
    steps.run(run, *options);
  });
}

/// A command as the program gvd knows it, whatever its options are.
struct Command {
  CommandInfo info;
  std::function<int(int argc, const char* const* argv)> run;        ///< `run_command`
  std::function<std::string(const std::string& shell)> completion;  ///< the script for bash, zsh or fish
};

/// The script that completes a command in a shell, of options that `list` describes but for the general ones.
std::string describe_completion(const CommandInfo& info, OptionList& list, Options& options, const std::string& shell);

/// The command of these options and steps, for the table of gvd.
///
///     struct OwnOptions : Options { bool cut = false; };
///     Command segment_command() {
///       return make_command<OwnOptions>({"gvd-segment", "Labels ...", "  gvd-segment a.obj -n 30\n", {kFormats}},
///                                       {describe_own, segment});
///     }
template <class OwnOptions>
Command make_command(const CommandInfo& info, const CommandSteps<OwnOptions>& steps) {
  return {info, [=](int argc, const char* const* argv) { return run_command<OwnOptions>(info, steps, argc, argv); },
          [=](const std::string& shell) {
            const auto options = std::make_unique<OwnOptions>();
            OptionList list;
            steps.describe(list, *options);
            return describe_completion(info, list, *options, shell);
          }};
}

}  // namespace gvd::app
