// Ends a run: turns every exception into an exit code and one line.
//
// gvd::Error has a code, which selects the exit code. std::bad_alloc means that memory has run out, because of
// --max-memory or in the system. oneTBB and std::thread throw if a thread can't be started. Any other exception is a
// bug. If an exception can't be caught (in destructors and threads of oneTBB), the handler of std::terminate prints the
// line and sets the exit code. The memory limit is lifted before a message is made, and a fixed text replaces a message
// for which there is no memory.

#include "common/outcome.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "common/console.hpp"
#include "common/options/spelling.hpp"
#include "common/process.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

struct CodeWords {
  int exit_code;
  const char* words;
};

/// For each ErrorCode, in their order.
constexpr std::array<CodeWords, 7> kCodes{{{kUsage, "usage"},
                                           {kUnreadableInput, "unreadable input"},
                                           {kPreconditionNotMet, "precondition not met"},
                                           {kNoResult, "no valid result"},
                                           {kNotWritten, "not written"},
                                           {kReaderGone, "reader gone"},
                                           {kInterrupted, "interrupted"}}};
static_assert(static_cast<std::size_t>(ErrorCode::interrupted) + 1 == kCodes.size());

/// Parts of the message about a lack of memory, with options as the user writes them.
struct MemoryAdvice {
  bool is_limited = false;
  std::string limit = "--max-memory";  ///< with its value, if it is given
  std::string advice = "use a mesh with fewer or better-shaped triangles";
  std::string one_thread = "--threads 1";
};
MemoryAdvice g_memory;

Outcome out_of_memory() {
  const auto& [is_limited, limit, advice, one_thread] = g_memory;
  std::string message = is_limited
                            ? fmt::format("out of memory: the run needs more than {}; raise it, or {}", limit, advice)
                            : fmt::format("out of memory: up to {} in use; {}; use {} to stop such a run earlier",
                                          format_bytes(peak_memory_bytes()), advice, limit);
  return {kNoResult, std::move(message), "out of memory"};
}

/// Whether an exception says that a thread can't be started. oneTBB throws a std::runtime_error with the name of the
/// function that failed, and std::thread throws a std::system_error.
bool tells_of_threads(const std::exception& error) {
  const auto* const system = dynamic_cast<const std::system_error*>(&error);
  return (system != nullptr && system->code() == std::errc::resource_unavailable_try_again) ||
         std::string_view(error.what()).find("pthread_create") != std::string_view::npos;
}

Outcome describe_exception(const std::exception& error) {
  if (!tells_of_threads(error)) {
    return {kNoResult, fmt::format("unexpected: {}; please report it", error.what()), "unexpected error"};
  }
  if (g_memory.is_limited) return out_of_memory();  // there was no memory for the thread's stack
  return {kNoResult,
          "a thread could not be started: the system allows no more threads, or no memory for one; use " +
              g_memory.one_thread,
          "no thread"};
}

/// The text of an error, with options as the user writes them if they are known. If it begins with an option from a
/// file, the place in the file comes first.
std::string describe(const Error& error, const Options* options) {
  if (error.code() == ErrorCode::reader_gone) return "";
  if (options == nullptr) return error.what();
  const Given::Source* const blamed = options->given->find(first_option(error.text()));
  const std::string place = blamed == nullptr || blamed->place.empty() ? "" : blamed->place + ": ";
  return place + spell(*options->list, *options->given, error.text(), !place.empty());
}

/// The outcome of a run that ended with this exception; null if it ended without one, as can happen with
/// std::terminate.
Outcome describe_failure(const std::exception_ptr& failure, const Options* options) {
  if (!failure) return {kNoResult, "unexpected: ended without an exception; please report it", "unexpected error"};
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    const CodeWords& words = kCodes[static_cast<std::size_t>(error.code())];
    return {words.exit_code, describe(error, options), words.words};
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::exception& error) {
    return describe_exception(error);
  } catch (...) {
    return {kNoResult, "unexpected: an exception of an unknown type; please report it", "unexpected error"};
  }
}

// The names of the command and of its input, for std::terminate.
std::string g_command, g_input;
std::atomic_flag g_ending;
constinit thread_local bool t_ending = false;

[[noreturn]] void end_with_fixed_text() {
  constexpr std::string_view kText =
      ": error: out of memory, even for a message; use a mesh with fewer or better-shaped triangles\n";
  for (const std::string_view text : {std::string_view(g_command), kText}) {
    if (::write(STDERR_FILENO, text.data(), text.size()) < 0) break;
  }
  std::_Exit(kNoResult);
}

[[noreturn]] void end_with_message() {
  if (t_ending) end_with_fixed_text();
  t_ending = true;
  while (g_ending.test_and_set()) ::pause();  // another thread is ending the process
  limit_memory({});
  try {
    const Outcome outcome = describe_failure(std::current_exception(), nullptr);
    Console console(g_command, detect_console_style(), false, false);
    console.clear_line();
    if (!outcome.message.empty()) console.error((g_input.empty() ? "" : g_input + ": ") + outcome.message);
    std::_Exit(outcome.exit_code);
  } catch (...) {
    end_with_fixed_text();
  }
}

/// The exception that a function throws; null if it throws none.
std::exception_ptr catch_all(const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

Outcome run_guarded(const std::function<void()>& work, const Options* options) {
  std::exception_ptr failure = catch_all(work);
  limit_memory({});  // the message needs memory
  // A signal can make a system call fail, such as opening a pipe that nobody reads. That is not an error of its own.
  if (failure && interrupt_requested()) failure = catch_all(check_interrupt);
  return failure ? describe_failure(failure, options) : Outcome();
}

int run_process(const std::string& name, const std::function<int()>& work, const Options* options) {
  reserve_standard_streams();
  install_signal_handlers();
  int exit_code = kDone;
  const Outcome outcome = run_guarded([&] { exit_code = work(); }, options);
  if (outcome.exit_code == kReaderGone) return end_by_broken_pipe();
  if (!outcome.message.empty()) Console(name, {}, false, false).error(outcome.message);
  return outcome.exit_code != kDone ? outcome.exit_code : exit_code;
}

void limit_memory_of(const Options& options) {
  const std::optional<std::int64_t> limit = options.compute.max_memory;
  g_memory = {};
  g_memory.is_limited = limit.has_value();
  const OptionList& list = *options.list;
  const Given& given = *options.given;
  // Most of an exact diagram's memory is the points of its bisectors. A few long needles take as much memory as many
  // faces.
  const Option* const chords = list.find("chord_tolerance");
  if (chords != nullptr && list.why_idle(*chords, given).empty()) {
    g_memory.advice =
        spell(list, given, "use a coarser \1chord_tolerance\2, or a mesh with fewer or better-shaped triangles");
  }
  g_memory.limit = spell(list, given, placeholder("max_memory", limit ? format_bytes(*limit) : ""));
  g_memory.one_thread = spell(list, given, "\1threads=1\2");
  limit_memory(limit);
}

std::string format_bytes(std::int64_t bytes) {
  constexpr std::array<const char*, 5> kUnits{"bytes", "KiB", "MiB", "GiB", "TiB"};
  auto amount = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; amount >= 1024 && unit + 1 < kUnits.size(); ++unit) amount /= 1024;
  return unit == 0 || amount >= 100 ? fmt::format("{:.0f} {}", amount, kUnits[unit])
                                    : fmt::format("{:.3g} {}", amount, kUnits[unit]);
}

void report_termination(const std::string& command, const std::string& input) {
  g_command = command;
  g_input = input;
  set_command_name(command);
  std::set_terminate(end_with_message);
}

}  // namespace gvd::app
