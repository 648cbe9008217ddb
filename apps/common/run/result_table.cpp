#include "common/run/result_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace gvd::app {
namespace {

struct Column {
  std::string title;
  bool right = true;  ///< aligned
  std::function<std::string(const RunResult&)> text;
};

std::string figure(const std::optional<double>& value) { return value ? fmt::format("{:.6g}", *value) : "-"; }

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

}  // namespace

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
