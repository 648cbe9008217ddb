// The frame of every command: options in, an exit code out. Whatever goes wrong on the way, in the options or in the
// body, ends in one line on standard error and in the exit code of its kind.

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
#include "gvd/version.hpp"

namespace gvd::app {
namespace {

/// The page that --open writes where --view names none.
std::string default_page(const std::string& input) {
  const std::filesystem::path name =
      input == "-" ? std::filesystem::path("stdin") : std::filesystem::path(input).filename();
  const std::filesystem::path unpacked = file_extension(name.string()) == "gz" ? name.stem() : name;
  return unpacked.stem().string() + ".gvd.html";
}

}  // namespace

std::string help_footer(const std::string& examples) {
  return "\nExamples:\n" + examples +
         "\nExit codes: 0 done, 2 usage, 3 unreadable input, 4 input breaks a precondition,\n"
         "5 no valid result or out of memory, 6 output could not be written,\n"
         "130 interrupted; with several inputs, the code of the first one that failed.\n";
}

int run_described(const CommandInfo& info, OptionList& list, Options& options, int argc, const char* const* argv,
                  const std::function<void(const Given&)>& complete, const std::function<void(Run&)>& body) {
  keep_freed_memory();
  Given given;
  const auto work = [&]() -> int {
    describe(list, options.general);
    options.list = &list;
    options.given = &given;
    const CommandWords words{info.name, info.description, help_footer(info.examples), std::string(version())};
    const auto answer = [&] {
      const WaitForInput wait("--config");  // the file may be a pipe
      return parse_command_line(words, list, given, {argv + std::min(argc, 1), argv + argc});
    }();
    if (answer) {
      write_standard_output([&](std::ostream& out) { out << *answer; });
      return kDone;
    }
    options.input.path = options.input.paths.front();
    if (options.output.open && options.output.view.empty()) options.output.view = default_page(options.input.path);
    complete(given);
    check_inputs(options, info.formats);
    if (const auto missing = list.find_missing(given)) refuse_option(list, given, *missing);
    check_outputs(options, info.formats);
    if (!options.output.folder.empty()) return run_several(info.name, plan_runs(options), body);
    limit_memory_of(options);
    Console console(info.name, detect_console_style(), options.general.quiet, options.general.verbose);
    Run run(info.name, options, console);
    body(run);
    console.clear_bar();
    if (!run.written().empty()) console.note(fmt::format("wrote {}", fmt::join(run.written(), ", ")));
    const std::string failed = options.output.open ? open_page(options.output.view) : "";
    if (!failed.empty()) run.note(fmt::format("\1open\2: {}; open {} in a browser", failed, options.output.view));
    return kDone;
  };
  return run_process(info.name, work, &options);
}

std::string describe_completion(const CommandInfo& info, OptionList& list, Options& options, const std::string& shell) {
  describe(list, options.general);
  return make_completion(info.name, list, shell);
}

}  // namespace gvd::app
