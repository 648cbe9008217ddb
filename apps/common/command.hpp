#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/options/help.hpp"
#include "common/options/options.hpp"
#include "common/outcome.hpp"
#include "common/run.hpp"
#include "gvd/option_list.hpp"

namespace gvd::app {

/// What a command is, of options in a struct that inherits Options.
template <class OwnOptions>
struct CommandSteps {
  void (*describe)(OptionList& list, OwnOptions& options);
  /// What one run does. The options are its own: what it changes of them is what the report tells.
  void (*run)(Run& run, OwnOptions& options);
  /// Sets what follows from the options that were given, before they are checked. May be null.
  void (*complete)(OwnOptions& options, const Given& given) = nullptr;
};

/// The options of a command, which have their defaults before they are read, and its steps on them.
struct DescribedCommand {
  std::shared_ptr<Options> options;
  std::function<void(OptionList&)> describe;
  std::function<void(const Given&)> complete;
  std::function<void(Run&)> run;
};

/// A command as the program gvd knows it, whatever its options are.
struct Command {
  CommandInfo info;
  std::function<DescribedCommand()> make;
};

/// Reads the options and runs the command, with --output-dir once for each input: see `run_several`. Returns the exit
/// code: 0 where all goes well, or else that of `run_guarded`, with its message in one line on standard error.
int run_command(const Command& command, int argc, const char* const* argv);

/// The script that completes a command in bash, zsh or fish.
std::string make_completion(const Command& command, const std::string& shell);

/// The command of these options and steps, for the table of gvd.
///
///     struct OwnOptions : Options { bool cut = false; };
///     Command segment_command() {
///       return make_command<OwnOptions>({"gvd-segment", "Labels ...", "  gvd-segment a.obj -n 30\n", {kFormats}},
///                                       {describe_own, segment});
///     }
template <class OwnOptions>
Command make_command(const CommandInfo& info, const CommandSteps<OwnOptions>& steps) {
  return {info, [steps] {
            const auto own = std::make_shared<OwnOptions>();
            const auto given = std::make_shared<std::optional<OwnOptions>>();  // of all runs, before the first one
            return DescribedCommand{own, [=](OptionList& list) { steps.describe(list, *own); },
                                    [=](const Given& names) {
                                      if (steps.complete != nullptr) steps.complete(*own, names);
                                    },
                                    [=](Run& run) {
                                      if (*given) *own = **given;
                                      if (!*given) *given = *own;
                                      own->input = run.options().input;
                                      own->output = run.options().output;
                                      run.follow(*own);
                                      steps.run(run, *own);
                                    }};
          }};
}

}  // namespace gvd::app
