#include "common/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "common/options/check_options.hpp"
#include "common/options/file_extension.hpp"
#include "common/options/plan_runs.hpp"
#include "common/options/register_options.hpp"
#include "common/options/typed_options.hpp"
#include "common/outcome.hpp"
#include "common/process.hpp"
#include "common/run_several.hpp"

namespace gvd::app {
namespace {

std::string help_footer(const std::string& examples) {
  return "\nExamples:\n" + examples +
         "\nExit codes: 0 done, 2 usage, 3 unreadable input, 4 input breaks a precondition,\n"
         "5 no valid result or out of memory, 6 output could not be written,\n"
         "130 interrupted; of several inputs, that of the first one that failed.\n";
}

/// The description of a command whose options may not find the memory that they need.
CommandInfo guard(CommandInfo info) {
  report_termination(info.name);
  return info;
}

}  // namespace

Command::Command(CommandInfo info)
    : info_(guard(std::move(info))),
      line_(info_.name, info_.description, info_.name + " " + GVD_VERSION, help_footer(info_.examples)) {
  register_options(line_, options_, info_.output_formats, info_.sizes);
}

void Command::add_target(OptionText option, const std::vector<std::string>& extensions) {
  option.group = "Output";
  option.excludes.emplace_back("--output-dir");
  std::string& target = options_.output.own[option.names];
  if (extensions.empty()) return add_file(line_, option, target);
  line_.add_value(option, [&target, extensions](const std::string& text) -> std::optional<std::string> {
    if (std::find(extensions.begin(), extensions.end(), file_extension(text)) == extensions.end()) {
      return fmt::format("'{}': the extension must be one of .{}", printable(text), fmt::join(extensions, ", ."));
    }
    target = text;
    return std::nullopt;
  });
}

void Command::check() const { check_options(options_, {info_.output_formats, info_.materials}); }

int Command::run(int argc, const char* const* argv, const std::function<void(Run&)>& body) {
  keep_freed_memory();
  reserve_standard_streams();
  install_signal_handlers();
  int exit_code = kDone;
  const Outcome outcome = run_guarded([&] {
    if (const auto answer = line_.parse(argc, argv)) {
      return write_standard_output([&](std::ostream& out) { out << *answer; });
    }
    check();
    if (!options_.output.folder.empty()) {
      exit_code = run_several(info_.name, plan_runs(options_), body);
      return;
    }
    limit_memory_of(options_.compute);
    Console console(info_.name, detect_console_style(), options_.quiet, options_.verbose);
    Run run(info_.name, options_, console);
    body(run);
  });
  if (outcome.exit_code == kReaderGone) return end_by_broken_pipe();
  if (!outcome.message.empty()) Console(info_.name, {}, false, false).error(outcome.message);
  return outcome.exit_code != kDone ? outcome.exit_code : exit_code;
}

}  // namespace gvd::app
