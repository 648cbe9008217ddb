// Several inputs of one call (--output-dir): one run after the other in this process, and a table of them.
//
// Whatever a run throws is its own failure: a line with the name of its input, its exit code, and a row of the table.
// A run keeps nothing for the next one, except memory that glibc holds ready.

#include "common/run_several.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

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
void append_column(std::vector<std::string>& lines, const std::vector<std::string>& cells, bool right = true) {
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

struct RunEnd {
  Outcome outcome;
  RunFigures figures;
};

RunEnd run_one(const std::string& command, const Options& options, const std::function<void(Run&)>& body) {
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
  std::vector<std::string> inputs{"input"}, words{"result"}, regions{"regions"}, errors{"E"}, energies{"energy"},
      times{"time"};
  bool has_error = false, has_energy = false;
  for (const auto& [input, word, figures, seconds] : results) {
    inputs.push_back(input);
    words.push_back(word);
    regions.push_back(figures.regions ? fmt::format("{}", *figures.regions) : "-");
    errors.push_back(figure(figures.error_integral));
    energies.push_back(figure(figures.energy));
    times.push_back(fmt::format("{:.2f} s", seconds));
    has_error = has_error || errors.back() != "-";
    has_energy = has_energy || energies.back() != "-";
  }
  std::vector<std::string> lines(inputs.size());
  append_column(lines, inputs, false);
  append_column(lines, words, false);
  append_column(lines, regions);
  if (has_error) append_column(lines, errors);
  if (has_energy) append_column(lines, energies);
  append_column(lines, times);
  return lines;
}

}  // namespace gvd::app
