#include "common/run/run_apart.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/memory/heap_count.hpp"
#include "common/run/child_process.hpp"
#include "common/run/interrupt.hpp"
#include "common/run/outcome.hpp"
#include "common/run/termination.hpp"

namespace gvd::app {
namespace {

using nlohmann::json;

/// Errors of the input begin with its name already.
void print_error(const std::string& command, const std::string& input, const std::string& message) {
  if (message.empty()) return;
  const bool has_name = message.starts_with(input + ":") || message.starts_with(input + ",");
  const std::string named = has_name ? message : fmt::format("{}: {}", input, message);
  Console(command, {}, false, false).error(named);
}

/// What the child sends back.
std::string pack(const RunFigures& figures, const std::string& summary) {
  json packed{{"summary", summary}};
  if (figures.regions) packed["regions"] = *figures.regions;
  if (figures.error_integral) packed["error_integral"] = *figures.error_integral;
  if (figures.energy) packed["energy"] = *figures.energy;
  return packed.dump();
}

/// Nothing where the run had no such figure, or one that is not finite.
template <class T>
std::optional<T> number_in(const json& packed, const char* name) {
  const auto found = packed.find(name);
  return found != packed.end() && found->is_number() ? std::optional(found->get<T>()) : std::nullopt;
}

RunEnd unpack(const ChildEnd& child) {
  const json packed = json::parse(child.answer, nullptr, false);
  // std::terminate leaves no answer, but a message: see report_termination.
  if (packed.is_discarded()) return {child.exit_code, "ended early", {}};
  return {child.exit_code,
          packed["summary"],
          {number_in<std::int64_t>(packed, "regions"), number_in<double>(packed, "error_integral"),
           number_in<double>(packed, "energy")}};
}

int run_here(const std::string& command, const Options& options, const std::function<void(Run&)>& body,
             std::string& answer) {
  const std::string& input = options.input.path;
  report_termination(command, input);
  Console console(fmt::format("{}: {}", command, input), detect_console_style(), options.quiet, options.verbose);
  Run run(command, options, console);
  const Outcome outcome = run_guarded([&] {
    limit_memory_of(options.compute);
    body(run);
  });
  console.clear_bar();
  print_error(command, input, outcome.message);
  lift_heap_limit_here();  // what is done is reported
  answer = pack(run.figures(), outcome.summary);
  return outcome.exit_code;
}

/// What a process that a signal ended could not say itself.
std::string describe_signal(int signal) {
  if (signal == SIGKILL) return "killed, as systems do where memory ends; --max-memory ends such a run sooner";
  return fmt::format("ended by signal {} ({}); please report it", signal, ::strsignal(signal));
}

}  // namespace

RunEnd run_apart(const std::string& command, const Options& options, const std::function<void(Run&)>& body) {
  ChildEnd child;
  const auto here = [&](std::string& answer) { return run_here(command, options, body, answer); };
  const Outcome start = run_guarded([&] { child = run_in_child(here); });
  print_error(command, options.input.path, start.message);
  if (start.exit_code != kDone) return {start.exit_code, "not started", {}};
  if (child.signal == 0) return unpack(child);
  // A signal to the whole process group reaches the child twice; the second one ends it at once.
  const bool asked_to_end = child.signal == SIGTERM || child.signal == SIGINT;
  if (asked_to_end && interrupt_requested()) return {kInterrupted, "interrupted", {}};
  print_error(command, options.input.path, describe_signal(child.signal));
  return {kNoResult, child.signal == SIGKILL ? "killed" : "crashed", {}};
}

}  // namespace gvd::app
