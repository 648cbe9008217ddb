// Processes several inputs in a call (--output-dir), one run after the other in this process, and tabulates them, as a
// note and as CSV (--summary).
//
// An exception fails only its own run, with a line that names its input, an exit code, and a row in the table. A run
// leaves nothing to the next one, except memory that glibc keeps.

#include "common/run_several.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <utility>

#include "common/outcome.hpp"
#include "common/process.hpp"
#include "common/referred_files.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// A figure of a run for the table. Numbers that are not whole have few digits.
std::string figure_of(const RunResult& run, const char* name) {
  const auto found = std::ranges::find(run.cells, name, &Cells::value_type::first);
  if (found == run.cells.end()) return "-";
  const std::string& text = found->second;
  return parse_number<std::int64_t>(text) ? text : fmt::format("{:.6g}", parse_number<double>(text).value_or(0));
}

/// The number of code points of UTF-8, which for most texts is the width on a terminal.
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

/// Prints the error of a run. Errors about the input already begin with its name.
void print_error(const std::string& command, const std::string& input, const std::string& message) {
  if (message.empty()) return;
  const bool has_name = message.starts_with(input + ":") || message.starts_with(input + ",");
  Console(command, {}, false, false).error(has_name ? message : fmt::format("{}: {}", input, message));
}

RunResult run_one(const std::string& command, const Options& options, const std::function<void(Run&)>& body) {
  const auto start = std::chrono::steady_clock::now();
  const std::string& input = options.input.path;
  report_termination(command, input);
  Console console(fmt::format("{}: {}", command, input), detect_console_style(), options.general.quiet,
                  options.general.verbose);
  Run run(command, options, console);
  const Outcome outcome = run_guarded(
      [&] {
        limit_memory_of(options);
        body(run);
      },
      &options);
  console.clear_bar();
  print_error(command, input, outcome.message);
  const std::string result =
      outcome.exit_code == kDone ? outcome.summary : fmt::format("failed ({}: {})", outcome.exit_code, outcome.summary);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return {input,
          result,
          taken.count(),
          outcome.exit_code,
          outcome.message,
          list_figures(run.report()),
          run.written().size()};
}

/// Quotes a field of CSV if necessary (RFC 4180).
std::string quote_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

void append_figures(const Json& value, const std::string& name, Cells& cells) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) append_figures(member, name + '.' + key, cells);
  } else if (value.is_string()) {
    cells.emplace_back(name, value.get<std::string>());
  } else if (value.is_boolean() || (value.is_number() && std::isfinite(value.get<double>()))) {
    cells.emplace_back(name, value.dump());
  }
}

/// The names of all figures, in the order in which they first occur in the runs.
std::vector<std::string> list_columns(const std::vector<RunResult>& results) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const RunResult& result : results) {
    for (const auto& [name, value] : result.cells) {
      if (known.insert(name).second) names.push_back(name);
    }
  }
  return names;
}

/// Formats the rows of the results from `first` on, then the rows of inputs without a result.
std::string format_rows(const std::vector<std::string>& inputs, const std::vector<RunResult>& results,
                        std::size_t first, const std::vector<std::string>& columns) {
  std::string rows;
  for (std::size_t i = first; i < results.size(); ++i) {
    const RunResult& result = results[i];
    const std::map<std::string, std::string> values(result.cells.begin(), result.cells.end());
    rows += fmt::format("{},{},{},", quote_field(result.input), result.exit_code, quote_field(result.error));
    for (const std::string& column : columns) {
      const auto value = values.find(column);
      rows += value == values.end() ? "," : quote_field(value->second) + ',';
    }
    rows += fmt::format("{:.3f}\n", result.seconds);
  }
  for (std::size_t i = results.size(); i < inputs.size(); ++i) {
    rows += fmt::format("{},,not run,{}\n", quote_field(inputs[i]), std::string(columns.size(), ','));
  }
  return rows;
}

/// The file of --summary. Rows are appended, so that the time for a row does not grow with the number of earlier runs.
/// The file is rewritten completely if the last run has a new column, or if appending fails.
class SummaryFile {
 public:
  explicit SummaryFile(std::string path) : path_(std::move(path)) {}

  /// Writes the rows of new results, and then rows for the remaining `inputs`.
  Outcome write(const std::vector<std::string>& inputs, const std::vector<RunResult>& results) {
    if (path_.empty()) return {};
    const auto is_known = [this](const auto& cell) { return contains(columns_, cell.first); };
    const bool fits = written_ > 0 && std::ranges::all_of(results.back().cells, is_known);
    std::fstream file;
    if (fits) file.open(path_, std::ios::in | std::ios::out | std::ios::ate);  // fails if the file is gone
    const bool is_appended = fits && (file << format_rows(inputs, results, written_, columns_)).flush();
    Outcome outcome;
    if (!is_appended) {
      const std::string table = format_summary(inputs, results);
      outcome = run_guarded([&] { write_file(path_, [&](std::ostream& out) { out << table; }); });
      columns_ = list_columns(results);
    }
    written_ = outcome.exit_code == kDone ? results.size() : 0;
    return outcome;
  }

 private:
  std::string path_;  // empty: none
  std::vector<std::string> columns_;
  std::size_t written_ = 0;  // number of results written; 0 before the first and after a failure
};

}  // namespace

int run_several(const std::string& command, const std::vector<Options>& runs, const std::function<void(Run&)>& body) {
  check_referred_files(runs);
  std::vector<RunResult> results;
  int exit_code = kDone;
  SummaryFile file(runs.front().output.summary);
  Outcome summary;
  for (const Options& options : runs) {
    results.push_back(run_one(command, options, body));
    summary = file.write({}, results);
    if (exit_code == kDone) exit_code = results.back().exit_code;
    if (interrupt_requested()) break;
  }
  if (results.size() < runs.size()) summary = file.write(runs.front().input.paths, results);
  print_error(command, runs.front().output.summary, summary.message);
  if (exit_code == kDone) exit_code = summary.exit_code;
  // The signal may have come after the last run was done.
  if (exit_code == kDone && results.size() < runs.size()) exit_code = kInterrupted;
  Console console(command, {}, runs.front().general.quiet, false);
  for (const std::string& line : format_results(results)) console.note(line);
  std::size_t files = 0;
  for (const RunResult& result : results) files += result.files;
  const OutputOptions& output = runs.front().output;
  std::string written =
      files > 0 ? fmt::format("{} to {}", counted(std::int64_t(files), "file", "files"), output.folder) : "";
  if (!output.summary.empty() && summary.exit_code == kDone) written += (files > 0 ? ", " : "") + output.summary;
  if (!written.empty()) console.note("wrote " + written);
  return exit_code;
}

std::vector<std::string> format_results(const std::vector<RunResult>& results) {
  std::array<std::vector<std::string>, 6> columns{{{"input"}, {"result"}, {"generators"}, {"E"}, {"energy"}, {"time"}}};
  for (const RunResult& run : results) {
    const std::array<std::string, 6> cells{run.input,
                                           run.result,
                                           figure_of(run, "diagram.cells"),
                                           figure_of(run, "diagram.verify.error_integral"),
                                           figure_of(run, "results.final_energy"),
                                           fmt::format("{:.2f} s", run.seconds)};
    for (std::size_t i = 0; i < cells.size(); ++i) columns[i].push_back(cells[i]);
  }
  std::vector<std::string> lines(results.size() + 1);
  for (const std::vector<std::string>& cells : columns) {
    const bool is_text = cells[0] == "input" || cells[0] == "result", may_lack = !is_text && cells[0] != "time";
    const bool lacks = std::count(cells.begin(), cells.end(), "-") == std::ssize(results);
    if (!may_lack || !lacks) append_column(lines, cells, !is_text);
  }
  return lines;
}

Cells list_figures(const RunReport& report) {
  Cells cells;
  for (const char* part : {"input", "diagram", "results"}) append_figures(report.at(part), part, cells);
  return cells;
}

std::string format_summary(const std::vector<std::string>& inputs, const std::vector<RunResult>& results) {
  const std::vector<std::string> columns = list_columns(results);
  return fmt::format("input,exit_code,error,{}{}seconds\n", fmt::join(columns, ","), columns.empty() ? "" : ",") +
         format_rows(inputs, results, 0, columns);
}

}  // namespace gvd::app
