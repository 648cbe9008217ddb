// The frame of every command: reads the options, runs the body, and returns an exit code. Every failure, in the options
// or in the body, ends in one line on standard error and the exit code for its kind.

#include "common/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "common/open_page.hpp"
#include "common/options/command_line.hpp"
#include "common/options/completion.hpp"
#include "common/options/spelling.hpp"
#include "common/process.hpp"
#include "common/run_several.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

/// The page that --open writes if --view names none.
std::string default_page(const std::string& input) {
  const std::filesystem::path name =
      input == "-" ? std::filesystem::path("stdin") : std::filesystem::path(input).filename();
  const std::filesystem::path unpacked = file_extension(name.string()) == "gz" ? name.stem() : name;
  return unpacked.stem().string() + ".gvd.html";
}

}  // namespace

int run_command(const Command& command, int argc, const char* const* argv) {
  const CommandInfo& info = command.info;
  report_termination(info.name);  // reading the options may run out of memory
  keep_freed_memory();
  const DescribedCommand made = command.make();
  Options& options = *made.options;
  OptionList list;
  Given given;
  const auto work = [&]() -> int {
    made.describe(list);
    describe(list, options.general);
    options.list = &list;
    options.given = &given;
    const auto answer = [&] {
      const WaitForInput wait("--config");  // the file may be a pipe
      return parse_command_line(info, list, given, {argv + std::min(argc, 1), argv + argc});
    }();
    if (answer) {
      write_standard_output([&](std::ostream& out) { out << *answer; });
      return kDone;
    }
    options.input.path = options.input.paths.front();
    if (options.output.open && options.output.view.empty()) options.output.view = default_page(options.input.path);
    made.complete(given);
    check_inputs(options, info.formats);
    if (const auto missing = list.find_missing(given)) refuse_option(list, given, *missing);
    check_outputs(options, info.formats);
    if (!options.output.folder.empty()) return run_several(info.name, plan_runs(options), made.run);
    limit_memory_of(options);
    Console console(info.name, detect_console_style(), options.general.quiet, options.general.verbose);
    Run run(info.name, options, console);
    made.run(run);
    console.clear_bar();
    if (!run.written().empty()) console.note(fmt::format("wrote {}", fmt::join(run.written(), ", ")));
    const std::string failed = options.output.open ? open_page(options.output.view) : "";
    if (!failed.empty()) run.note(fmt::format("\1open\2: {}; open {} in a browser", failed, options.output.view));
    return kDone;
  };
  return run_process(info.name, work, &options);
}

std::string make_completion(const Command& command, const std::string& shell) {
  const DescribedCommand made = command.make();
  OptionList list;
  made.describe(list);
  describe(list, made.options->general);
  return make_completion(command.info.name, list, shell);
}

}  // namespace gvd::app
