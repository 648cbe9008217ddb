#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gvd::app {

/// How long a step still takes, from the time that its first part took.
class TimeLeft {
 public:
  /// Seconds, or nothing while too little is known: in the first second, and before a hundredth of the step is done.
  /// `now`: seconds, from any start. A step of another name, or one that begins again, is measured anew.
  std::optional<double> update(std::string_view step, double fraction, double now);

 private:
  std::string step_;
  double first_fraction_ = 0, last_fraction_ = 0, started_ = 0;
};

/// "12 s left", "3 min left" or "2 h left".
std::string format_time_left(double seconds);

/// Capabilities of standard error.
struct ConsoleStyle {
  bool bars = false;                           ///< a terminal that can redraw a line
  bool colours = false;                        ///< a terminal, and NO_COLOR is not set
  int width = 80;                              ///< columns
  std::chrono::milliseconds interval{10'000};  ///< between two lines of progress, or two drawings of a bar
};

/// Asks the terminal and the environment (TERM, NO_COLOR). Bars are off on anything but a terminal.
ConsoleStyle detect_console_style();

/// Contents of a progress bar.
struct Bar {
  std::string_view step;
  std::string_view status = {};  ///< what the step has found so far
  double fraction = 0;           ///< clamped to [0, 1]
  std::optional<double> seconds_left = {};
};

/// One line, without line break, of at most `style.width` - 1 columns: step and status, a bar, percents and, where the
/// line has room, the time left.
std::string render_bar(const Bar& bar, const ConsoleStyle& style);

/// The same in words, with as much as is known: "sampling: 45 %, 12 s left".
std::string describe_progress(const Bar& bar);

/// Standard error: messages of one line each, and a progress bar below them.
class Console {
 public:
  Console(std::string command, const ConsoleStyle& style, bool quiet, bool verbose);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void error(std::string_view message);
  void note(std::string_view message);    ///< not printed where quiet
  void detail(std::string_view message);  ///< printed only where verbose
  /// Sets the text that bars show behind the name of their step, from now on.
  void set_status(std::string status) { status_ = std::move(status); }
  /// Redraws the bar, or prints a line of progress where there are no bars, once in each `interval` of the style. The
  /// bar of a new step comes sooner. Nothing where the console is quiet.
  void bar(std::string_view step, double fraction);
  void clear_bar();
  /// Clears the terminal's line, where another console may have drawn a bar.
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
