#include "common/run/termination.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "common/memory/heap_count.hpp"
#include "common/run/console.hpp"
#include "common/run/outcome.hpp"

namespace gvd::app {
namespace {

/// Kept outside of the heap, which may have no room left. A path of Linux has at most 4096 bytes.
std::array<char, 5000> g_command{}, g_input{};
std::atomic_flag g_ending;
constinit thread_local bool t_ending = false;

/// For where the message has no memory either.
[[noreturn]] void end_with_fixed_text() {
  constexpr std::string_view kText = ": error: out of memory, even for a message; simplify the mesh\n";
  for (const std::string_view text : {std::string_view(g_command.data()), kText}) {
    if (::write(STDERR_FILENO, text.data(), text.size()) < 0) break;
  }
  std::_Exit(kNoResult);
}

[[noreturn]] void end_with_message() {
  if (t_ending) end_with_fixed_text();
  t_ending = true;
  while (g_ending.test_and_set()) ::pause();  // another thread ends the process
  lift_heap_limit_here();
  try {
    const Outcome outcome = describe_failure(std::current_exception());
    Console console(g_command.data(), detect_console_style(), false, false);
    console.clear_line();
    const std::string place = g_input[0] == '\0' ? "" : fmt::format("{}: ", g_input.data());
    if (!outcome.message.empty()) console.error(place + outcome.message);
    std::_Exit(outcome.exit_code);
  } catch (...) {
    end_with_fixed_text();
  }
}

template <std::size_t kSize>
void keep(const std::string& text, std::array<char, kSize>& kept) {
  kept.fill('\0');
  std::copy_n(text.begin(), std::min(text.size(), kSize - 1), kept.begin());
}

}  // namespace

void report_termination(const std::string& command, const std::string& input) {
  keep(command, g_command);
  keep(input, g_input);
  std::set_terminate(end_with_message);
}

}  // namespace gvd::app
