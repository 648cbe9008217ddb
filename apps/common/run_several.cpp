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

struct Column {
  std::string title;
  bool right = true;  ///< aligned
  std::function<std::string(const RunResult&)> text;
};

std::string figure(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "-";
}

/// Code points of UTF-8: what a terminal shows of most texts.
std::size_t displayed_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::vector<Column> choose_columns(const std::vector<RunResult>& results) {
  const auto any = [&](auto member) {
    return std::any_of(results.begin(), results.end(),
                       [&](const RunResult& result) { return (result.figures.*member).has_value(); });
  };
  std::vector<Column> columns{{"input", false, [](const RunResult& r) { return r.input; }},
                              {"result", false, [](const RunResult& r) { return r.result; }},
                              {"regions", true, [](const RunResult& r) {
                                 return r.figures.regions ? fmt::format("{}", *r.figures.regions) : "-";
                               }}};
  if (any(&RunFigures::error_integral)) {
    columns.push_back({"E", true, [](const RunResult& r) { return figure(r.figures.error_integral); }});
  }
  if (any(&RunFigures::energy)) {
    columns.push_back({"energy", true, [](const RunResult& r) { return figure(r.figures.energy); }});
  }
  columns.push_back({"time", true, [](const RunResult& r) { return fmt::format("{:.2f} s", r.seconds); }});
  return columns;
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
  std::vector<std::string> lines(results.size() + 1);
  for (const Column& column : choose_columns(results)) {
    std::vector<std::string> cells{column.title};
    for (const RunResult& result : results) cells.push_back(column.text(result));
    std::size_t width = 0;
    for (const std::string& cell : cells) width = std::max(width, displayed_width(cell));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!lines[i].empty()) lines[i] += "  ";
      const std::string blanks(width - displayed_width(cells[i]), ' ');
      lines[i] += column.right ? blanks + cells[i] : cells[i] + blanks;
    }
  }
  return lines;
}

}  // namespace gvd::app
