#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gvd::app {

/// Estimates how long a step still takes, from the time that its first part took.
class TimeLeft {
 public:
  /// Returns seconds, or nothing as long as too little is known: in the first second, and before a hundredth of the
  /// step is done. `now`: seconds from any origin. Starts over if the name of the step changes or the step begins
  /// again.
  std::optional<double> update(std::string_view step, double fraction, double now);

 private:
  std::string step_;
  double first_fraction_ = 0, last_fraction_ = 0, started_ = 0;
};

/// "12 s left", "3 min left" or "2 h left".
std::string format_time_left(double seconds);

/// Capabilities of standard error.
struct ConsoleStyle {
  bool bars = false;                           ///< standard error is a terminal that can redraw a line
  bool colours = false;                        ///< standard error is a terminal, and NO_COLOR is not set
  int width = 80;                              ///< columns
  std::chrono::milliseconds interval{10'000};  ///< between two lines of progress, or between two drawings of a bar
};

/// Queries the terminal and the environment (TERM, NO_COLOR). Bars are off if standard error is not a terminal.
ConsoleStyle detect_console_style();

/// Contents of a progress bar.
struct Bar {
  std::string_view step;
  std::string_view status = {};  ///< what the step has found so far
  double fraction = 0;           ///< clamped to [0, 1]
  std::optional<double> seconds_left = {};
};

/// Returns a line, without line break, of at most `style.width` - 1 columns: step and status, a bar, percents and, if
/// the line has room, the time left.
std::string render_bar(const Bar& bar, const ConsoleStyle& style);

/// Describes the same in words, as far as known: "sampling: 45 %, 12 s left".
std::string describe_progress(const Bar& bar);

/// Standard error: messages of one line each, and a progress bar below them.
class Console {
 public:
  Console(std::string command, const ConsoleStyle& style, bool quiet, bool verbose);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void error(std::string_view message);
  void note(std::string_view message);    ///< not printed if quiet
  void detail(std::string_view message);  ///< printed only if verbose
  /// Sets the text that bars show after the name of their step from now on.
  void set_status(std::string status) { status_ = std::move(status); }
  /// Redraws the bar, or prints a line of progress if there are no bars, at most once in each `interval` of the style.
  /// The bar of a new step is drawn sooner. Does nothing if the console is quiet.
  void bar(std::string_view step, double fraction);
  void clear_bar();
  /// Clears the terminal's line, on which another console may have drawn a bar.
  void clear_line() const;

 private:
  void line(std::string_view kind, std::string_view message);

  std::string command_;
  ConsoleStyle style_;
  bool quiet_;
  bool verbose_;
  std::string status_;
  TimeLeft time_left_;
  bool bar_drawn_ = false;
  std::string drawn_step_;
  std::chrono::steady_clock::time_point next_draw_;
};

}  // namespace gvd::app
