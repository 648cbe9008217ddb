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
  OutputFormats formats;    ///< `-o -` writes the first one unless --output-format names another
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

/// The frame of a command, of options that `list` describes; for `run_command`.
int run_described(const CommandInfo& info, OptionList& list, Options& options, int argc, const char* const* argv,
                  const std::function<void(const Given&)>& complete, const std::function<void(Run&)>& body);

/// Reads the options and runs the command, with --output-dir once for each input: see `run_several`. Returns the exit
/// code: 0 where all goes well, or else that of `run_guarded`, with its message in one line on standard error.
///
///     struct OwnOptions : Options { bool cut = false; };
///     int main(int argc, char** argv) {
///       return run_command<OwnOptions>({"gvd-segment", "Labels ...", "  gvd-segment a.obj -n 30\n", {{"ply", "obj"}}},
///                                      {describe_own, segment}, argc, argv);
///     }
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

}  // namespace gvd::app
