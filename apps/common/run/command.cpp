#include "common/run/command.hpp"

#include <fmt/format.h>

#include <new>
#include <ostream>

#include "common/options/check_options.hpp"
#include "common/options/register_options.hpp"
#include "common/options/typed_options.hpp"
#include "common/run/name_options.hpp"
#include "common/run/standard_output.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

constexpr int kDone = 0, kUsage = 2, kNoResult = 5;

int exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_option:
      return kUsage;
    case ErrorCode::unreadable_input:
      return 3;
    case ErrorCode::precondition:
      return 4;
    case ErrorCode::no_valid_result:
      return kNoResult;
    case ErrorCode::unwritable_output:
      return 6;
    case ErrorCode::interrupted:
      return 130;
  }
  return kNoResult;
}

std::string help_footer(const std::string& examples) {
  return "\nExamples:\n" + examples +
         "\nExit codes: 0 done, 2 usage, 3 unreadable input, 4 input breaks a precondition, 5 no valid result,\n"
         "6 output could not be written, 130 interrupted.\n";
}

}  // namespace

Command::Command(CommandInfo info)
    : info_(std::move(info)),
      line_(info_.name, info_.description, info_.name + " " + GVD_VERSION, help_footer(info_.examples)) {
  register_options(line_, options_, info_.output_formats);
}

void Command::add_target(OptionText option) {
  option.group = "Output";
  add_file(line_, option, options_.output.own[option.names]);
}

int Command::run(int argc, const char* const* argv, const std::function<void(Run&)>& body) {
  reserve_standard_streams();
  install_signal_handlers();
  const ConsoleStyle style = detect_console_style();
  Console plain(info_.name, {}, false, false);
  try {
    if (const auto answer = line_.parse(argc, argv)) {
      write_standard_output([&](std::ostream& out) { out << *answer; });
      return kDone;
    }
    check_options(options_, info_.output_formats);
    Console console(info_.name, style, options_.quiet, options_.verbose);
    Run run(info_.name, options_, console);
    body(run);
    return kDone;
  } catch (const Error& error) {
    plain.error(name_options(error.what()));
    return exit_code(error.code());
  } catch (const ReaderGone&) {
    return end_by_broken_pipe();
  } catch (const std::bad_alloc&) {
    plain.error("out of memory; use a smaller mesh or fewer generators");
    return kNoResult;
  } catch (const std::exception& error) {
    plain.error(fmt::format("unexpected: {}; please report it", error.what()));
    return kNoResult;
  }
}

}  // namespace gvd::app
