// The frame of every command: options in, an exit code out. Whatever goes wrong on the way, in the options or in the
// body, ends in one line on standard error and in the exit code of its kind.

#include "common/command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <utility>

#include "common/open_page.hpp"
#include "common/options/config_file.hpp"
#include "common/options/typed_options.hpp"
#include "common/outcome.hpp"
#include "common/process.hpp"
#include "common/run_several.hpp"
#include "gvd/version.hpp"

namespace gvd::app {
namespace {

std::string help_footer(const std::string& examples) {
  return "\nExamples:\n" + examples +
         "\nExit codes: 0 done, 2 usage, 3 unreadable input, 4 input breaks a precondition,\n"
         "5 no valid result or out of memory, 6 output could not be written,\n"
         "130 interrupted; with several inputs, the code of the first one that failed.\n";
}

/// The page that --open writes where --view names none.
std::string default_page(const std::string& input) {
  const std::filesystem::path name =
      input == "-" ? std::filesystem::path("stdin") : std::filesystem::path(input).filename();
  const std::filesystem::path unpacked = file_extension(name.string()) == "gz" ? name.stem() : name;
  return unpacked.stem().string() + ".gvd.html";
}

/// The description of a command whose options may not find the memory that they need.
CommandInfo guard(CommandInfo info) {
  report_termination(info.name);
  return info;
}

}  // namespace

Command::Command(CommandInfo info) : info_(guard(std::move(info))), line_(info_.description, info_.name) {
  rules_ = info_.register_shared(line_, options_, info_.formats.extensions);
  line_.footer(help_footer(info_.examples));
}

void Command::add_target(const std::string& name, const std::string& description) {
  CLI::Option* const option = add_side_output(line_, name, options_.output.own[name], description);
  option->group("Output")->excludes("--output-dir");
}

void Command::print_results(std::function<std::string()> choose_format) {
  options_.output.prints = true;
  choose_format_ = std::move(choose_format);
}

void Command::complete_options() {
  for (const char* name : {"--within", "--mask", "--balance", "--shares", "--weights", "--density", "--fixed"}) {
    const CLI::Option* const option = line_.get_option_no_throw(name);
    if (option == nullptr || option->count() == 0) continue;
    options_.input.others.push_back(option->results().back());
    if (contains({"--shares", "--weights"}, name) && option->results().back() == "-")
      options_.input.piped.push_back(name);
  }
  OutputOptions& output = options_.output;
  if (output.open && output.view.empty()) output.view = default_page(options_.input.path);
  if (!output.prints || names_file(output)) return;
  if (!is_given(*line_.get_option("--output-format"))) output.formats = {choose_format_()};
  output.files = {"-"};
}

int Command::run(int argc, const char* const* argv, const std::function<void(Run&)>& body) {
  keep_freed_memory();
  reserve_standard_streams();
  install_signal_handlers();
  int exit_code = kDone;
  const Outcome outcome = run_guarded([&] {
    register_general(line_, options_, fmt::format("{} {}", info_.name, version()));
    const auto answer = [&] {
      const WaitForInput wait("--config");  // the file may be a pipe
      return parse_command_line(line_, rules_, argc, argv);
    }();
    if (answer) {
      return write_standard_output([&](std::ostream& out) { out << *answer; });
    }
    complete_options();
    check_options(options_, info_.formats);
    if (!options_.output.folder.empty()) {
      exit_code = run_several(info_.name, plan_runs(options_), body);
      return;
    }
    limit_memory_of(options_.compute);
    Console console(info_.name, detect_console_style(), options_.quiet, options_.verbose);
    Run run(info_.name, options_, console);
    body(run);
    console.clear_bar();
    if (!run.written().empty()) console.note(fmt::format("wrote {}", fmt::join(run.written(), ", ")));
    if (!options_.output.open) return;
    const std::string failed = open_page(options_.output.view);
    if (!failed.empty()) console.note(fmt::format("--open: {}; open {} in a browser", failed, options_.output.view));
  });
  if (outcome.exit_code == kReaderGone) return end_by_broken_pipe();
  if (!outcome.message.empty()) Console(info_.name, {}, false, false).error(outcome.message);
  return outcome.exit_code != kDone ? outcome.exit_code : exit_code;
}

}  // namespace gvd::app
