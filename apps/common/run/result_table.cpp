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
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!lines[i].empty()) lines[i] += "  ";
      lines[i] += column.right ? fmt::format("{:>{}}", cells[i], width) : fmt::format("{:<{}}", cells[i], width);
    }
  }
  return lines;
}

}  // namespace gvd::app
