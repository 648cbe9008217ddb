// What the commands tell of balanced cells.
#include "common/balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// A note names this many cells.
constexpr std::size_t kNamed = 8;

double largest_error(const BalancedDiagram& balanced) {
  double largest = 0;
  for (std::size_t i = 0; i < balanced.masses.size(); ++i) {
    largest = std::max(largest, std::abs(balanced.masses[i] / balanced.targets[i] - 1));
  }
  return largest;
}

/// Notes what keeps cells from their shares.
void note_misses(Run& run, const BalancedDiagram& balanced) {
  std::vector<std::int32_t> cells;
  for (const auto& set : balanced.tied) {
    for (const GeneratorId g : set) cells.push_back(g.value());
  }
  if (!cells.empty()) {
    const auto named = cells.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, cells.size()));
    run.console().note(
        fmt::format("{}: no weights divide what is beyond a vertex where the paths of both cells bend, or a "
                    "weight is at its bound: {}{}; other generators may help",
                    counted(std::ssize(cells), "cell has no share of its own", "cells have no shares of their own"),
                    fmt::join(cells.begin(), named, ", "), named == cells.end() ? "" : ", ..."));
  }
  if (!balanced.converged) {
    run.console().note(
        fmt::format("balancing ended after {} diagrams, before all cells had their shares", balanced.diagrams));
  }
}

}  // namespace

void report_balance(Run& run, const BalancedDiagram& balanced) {
  run.console().note(
      fmt::format("cells differ from their shares by at most {:.2g}, with a coefficient of variation of {:.2g}",
                  largest_error(balanced), balanced.variation));
  note_misses(run, balanced);
  Json& result = run.report().results()["balance"];
  result["converged"] = balanced.converged;
  result["variation"] = balanced.variation;
  result["largest_error"] = largest_error(balanced);
  result["diagrams"] = balanced.diagrams;
  result["tied"] = Json::array();
  for (const auto& set : balanced.tied) {
    Json& cells = result["tied"].emplace_back(Json::array());
    for (const GeneratorId g : set) cells.push_back(g.value());
  }
  result["masses"] = balanced.masses;
  result["targets"] = balanced.targets;
}

}  // namespace gvd::app
