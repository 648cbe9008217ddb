// Writes to a command's standard error: lines of messages and, on a terminal, a progress bar below them.
//
// A message clears the bar, and the next call of the progress callback draws it again: at most ten times a second, or
// fifty times if steps change. Without a bar, a line of progress is printed every ten seconds. Every message is one
// line: control characters become blanks, so that no file name can change the state of a terminal. The time left
// assumes that the rest of the step is as fast as the part that is done.

#include "common/console.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "gvd/option_text.hpp"

namespace gvd::app {
namespace {

/// The least time before the bar of a new step is drawn. It is short, because the step may not report again for a long
/// time.
constexpr std::chrono::milliseconds kStepInterval{20};

constexpr int kStepColumns = 24;
constexpr int kPercentColumns = 7;  // "] 100 %"
constexpr int kSmallestBar = 10;
constexpr int kTimeColumns = 13;  // "  59 min left"
constexpr int kLeastTimedWidth = 70;
constexpr std::string_view kClearLine = "\r\x1b[K";

constexpr double kLeastSeconds = 1;
constexpr double kLeastShare = 0.01;
/// If the fraction of a step falls by more than this, the step has begun again; if it falls by less, some of its work
/// was discarded.
constexpr double kFall = 0.1;

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

void write_stderr(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::optional<double> TimeLeft::update(std::string_view step, double fraction, double now) {
  if (step != step_ || fraction < last_fraction_ - kFall) {
    step_ = step;
    first_fraction_ = last_fraction_ = fraction;
    started_ = now;
  }
  last_fraction_ = std::max(last_fraction_, fraction);
  const double share = last_fraction_ - first_fraction_, taken = now - started_;
  if (taken < kLeastSeconds || share < kLeastShare) return std::nullopt;
  return taken * (1 - last_fraction_) / share;
}

std::string format_time_left(double seconds) {
  constexpr double kMinute = 60, kHour = 3600, kMost = 999;
  if (seconds < kMinute) return fmt::format("{:.0f} s left", std::ceil(seconds));
  if (seconds < kHour) return fmt::format("{:.0f} min left", std::ceil(seconds / kMinute));
  return fmt::format("{:.0f} h left", std::min(kMost, std::ceil(seconds / kHour)));
}

ConsoleStyle detect_console_style() {
  ConsoleStyle style;
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  style.bars = ::isatty(STDERR_FILENO) == 1 && !dumb;
  if (style.bars) style.interval = std::chrono::milliseconds(100);
  style.colours = style.bars && !is_set("NO_COLOR");
  winsize size{};
  if (style.bars && ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) style.width = size.ws_col;
  return style;
}

std::string render_bar(const Bar& bar, const ConsoleStyle& style) {
  const double shown = std::clamp(bar.fraction, 0.0, 1.0);
  const int percent = static_cast<int>(shown * 100);
  const std::string text = bar.status.empty() ? std::string(bar.step) : fmt::format("{} {}", bar.step, bar.status);
  const int time_columns = style.width < kLeastTimedWidth ? 0 : kTimeColumns;
  const int room = style.width - 1 - 2 - kPercentColumns - time_columns;  // for text and cells
  if (room < kStepColumns + kSmallestBar) {
    const int columns = std::max(0, style.width - 1 - 6);
    return fmt::format("{} {:3} %", text.substr(0, columns), percent);
  }
  const int columns = std::clamp(static_cast<int>(text.size()), kStepColumns, room - kSmallestBar);
  const int cells = room - columns, filled = static_cast<int>(shown * cells);
  const std::string done(filled, '#'), rest(cells - filled, '.');
  const std::string_view on = style.colours ? "\x1b[36m" : "", off = style.colours ? "\x1b[0m" : "";
  std::string line = fmt::format("{:{}.{}} [{}{}{}{}] {:3} %", text, columns, columns, on, done, off, rest, percent);
  if (bar.seconds_left && time_columns > 0) line += fmt::format("  {}", format_time_left(*bar.seconds_left));
  return line;
}

std::string describe_progress(const Bar& bar) {
  std::string text = fmt::format("{}: {:.0f} %", bar.step, std::floor(100 * std::clamp(bar.fraction, 0.0, 1.0)));
  if (!bar.status.empty()) text += fmt::format(", {}", bar.status);
  if (bar.seconds_left) text += fmt::format(", {}", format_time_left(*bar.seconds_left));
  return text;
}

Console::Console(std::string command, const ConsoleStyle& style, bool quiet, bool verbose)
    : command_(std::move(command)),
      style_(style),
      quiet_(quiet),
      verbose_(verbose),
      next_draw_(style.bars ? std::chrono::steady_clock::time_point()
                            : std::chrono::steady_clock::now() + style.interval) {}

Console::~Console() { clear_bar(); }

void Console::line(std::string_view kind, std::string_view message) {
  clear_bar();
  // File names and messages of libraries may contain line breaks and sequences that change the state of a terminal.
  write_stderr(user_text(fmt::format("{}: {}{}", command_, kind, message), std::string::npos) + '\n');
}

void Console::error(std::string_view message) { line("error: ", message); }

void Console::note(std::string_view message) {
  if (!quiet_) line("", message);
}

void Console::detail(std::string_view message) {
  if (verbose_ && !quiet_) line("", message);
}

void Console::bar(std::string_view step, double fraction) {
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  const bool is_new = style_.bars && step != drawn_step_ && now > next_draw_ - style_.interval + kStepInterval;
  if (!is_new && now < next_draw_) return;
  next_draw_ = now + style_.interval;
  drawn_step_ = step;
  const double seconds = std::chrono::duration<double>(now.time_since_epoch()).count();
  const Bar bar{step, status_, fraction, time_left_.update(step, fraction, seconds)};
  if (!style_.bars) return line("", describe_progress(bar));
  write_stderr(fmt::format("{}{}", kClearLine, render_bar(bar, style_)));
  bar_drawn_ = true;
}

void Console::clear_bar() {
  if (bar_drawn_) clear_line();
  bar_drawn_ = false;
}

void Console::clear_line() const {
  if (style_.bars) write_stderr(kClearLine);
}

}  // namespace gvd::app
