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

/// The steps of a command, with its options in a struct that inherits Options.
template <class OwnOptions>
struct CommandSteps {
  void (*describe)(OptionList& list, OwnOptions& options);
  /// Does a run. The options belong to this run, and the report shows them as the run leaves them.
  void (*run)(Run& run, OwnOptions& options);
  /// Sets options that follow from the given ones, before they are checked. May be null.
  void (*complete)(OwnOptions& options, const Given& given) = nullptr;
};

/// The options of a command, initially with their defaults, and the steps that work on them.
struct DescribedCommand {
  std::shared_ptr<Options> options;
  std::function<void(OptionList&)> describe;
  std::function<void(const Given&)> complete;
  std::function<void(Run&)> run;
};

/// A command of the program gvd, independent of the type of its options.
struct Command {
  CommandInfo info;
  std::function<DescribedCommand()> make;
};

/// Reads the options and runs the command, with --output-dir once for each input (see `run_several`). Returns 0 on
/// success, and otherwise the exit code of `run_guarded`, with its message in one line on standard error.
int run_command(const Command& command, int argc, const char* const* argv);

/// Makes the script that completes a command in bash, zsh or fish.
std::string make_completion(const Command& command, const std::string& shell);

/// Makes a command with these options and steps, for the table of gvd.
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
            const auto given = std::make_shared<std::optional<OwnOptions>>();  // the options before the first run,
                                                                               // which are the same for all runs
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
