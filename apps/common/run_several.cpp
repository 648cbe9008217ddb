// Several inputs of one call (--output-dir): one run after the other in this process, and a table of them.
//
// Whatever a run throws is its own failure: a line with the name of its input, its exit code, and a row of the table.
// A run keeps nothing for the next one, except memory that glibc holds ready.

#include "common/run_several.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "common/outcome.hpp"
#include "common/process.hpp"

namespace gvd::app {
namespace {

std::string figure(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "-";
}

/// Code points of UTF-8: what a terminal shows of most texts.
std::int64_t displayed_width(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

/// Appends a column to the lines of a table; `cells[0]` is its title.
void append_column(std::vector<std::string>& lines, const std::vector<std::string>& cells, bool right) {
  std::int64_t width = 0;
  for (const std::string& cell : cells) width = std::max(width, displayed_width(cell));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!lines[i].empty()) lines[i] += "  ";
    const std::string blanks(width - displayed_width(cells[i]), ' ');
    lines[i] += right ? blanks + cells[i] : cells[i] + blanks;
  }
}

/// Errors of the input begin with its name already.
void print_error(const std::string& command, const std::string& input, const std::string& message) {
  if (message.empty()) return;
  const bool has_name = message.starts_with(input + ":") || message.starts_with(input + ",");
  Console(command, {}, false, false).error(has_name ? message : fmt::format("{}: {}", input, message));
}

std::pair<Outcome, RunFigures> run_one(const std::string& command, const Options& options,
                                       const std::function<void(Run&)>& body) {
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
  return {outcome, run.figures()};
}

}  // namespace

int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body) {
  std::vector<RunResult> results;
  int exit_code = kDone;
  for (const Options& options : runs) {
    const auto start = std::chrono::steady_clock::now();
    const auto [outcome, figures] = run_one(command, options, body);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    const std::string result = outcome.exit_code == kDone
                                   ? outcome.summary
                                   : fmt::format("failed ({}: {})", outcome.exit_code, outcome.summary);
    results.push_back({options.input.path, result, figures, taken.count()});
    if (exit_code == kDone) exit_code = outcome.exit_code;
    if (interrupt_requested()) break;
  }
  // The last run may have been done when the signal came.
  if (exit_code == kDone && results.size() < runs.size()) exit_code = kInterrupted;
  Console console(command, {}, runs.front().quiet, false);
  for (const std::string& line : format_results(results)) console.note(line);
  return exit_code;
}

std::vector<std::string> format_results(const std::vector<RunResult>& results) {
  std::array<std::vector<std::string>, 6> columns{{{"input"}, {"result"}, {"regions"}, {"E"}, {"energy"}, {"time"}}};
  for (const auto& [input, word, figures, seconds] : results) {
    const std::string regions = figures.regions ? fmt::format("{}", *figures.regions) : "-";
    const std::array<std::string, 6> cells{
        input, word, regions, figure(figures.error_integral), figure(figures.energy), fmt::format("{:.2f} s", seconds)};
    for (std::size_t i = 0; i < cells.size(); ++i) columns[i].push_back(cells[i]);
  }
  std::vector<std::string> lines(results.size() + 1);
  for (const std::vector<std::string>& cells : columns) {
    const bool is_text = cells[0] == "input" || cells[0] == "result",
               may_lack = cells[0] == "E" || cells[0] == "energy";
    const bool lacks = std::count(cells.begin(), cells.end(), "-") == std::ssize(results);
    if (!may_lack || !lacks) append_column(lines, cells, !is_text);
  }
  return lines;
}

}  // namespace gvd::app
