// What the operations that make diagrams share: their steps, and words and figures of the result.

#include "gvd/diagram_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "figures.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// A note names this many cells.
constexpr std::size_t kNamedCells = 8;

double largest_error(const BalancedDiagram& balanced) {
  double largest = 0;
  for (std::size_t i = 0; i < balanced.masses.size(); ++i) {
    largest = std::max(largest, std::abs(balanced.masses[i] / balanced.targets[i] - 1));
  }
  return largest;
}

/// Notes what keeps cells from their shares.
void note_misses(Observer& observer, const BalancedDiagram& balanced) {
  std::vector<std::int32_t> cells;
  for (const auto& set : balanced.tied) {
    for (const GeneratorId g : set) cells.push_back(g.value());
  }
  if (!cells.empty()) {
    const auto named = cells.begin() + static_cast<std::ptrdiff_t>(std::min(kNamedCells, cells.size()));
    observer.note(
        fmt::format("{}: no weights divide what is beyond a vertex where the paths of both cells bend, or a "
                    "weight is at its bound: {}{}; other generators may help",
                    counted(std::ssize(cells), "cell has no share of its own", "cells have no shares of their own"),
                    fmt::join(cells.begin(), named, ", "), named == cells.end() ? "" : ", ..."));
  }
  if (!balanced.converged) {
    observer.note(
        fmt::format("balancing ended after {} diagrams, before all cells had their shares", balanced.diagrams));
  }
}

}  // namespace

Diagram compute_in_steps(Observer& observer, DiagramOptions options, const DiagramMaker& compute) {
  const Step whole(observer, "diagram");
  std::optional<Step> step;
  std::string current;
  options.progress = [&](std::string_view name, double fraction) {
    if (name != current) {
      current = name;
      step.reset();
      step.emplace(observer, "diagram: " + current);
    }
    return observer.progress(name, fraction);
  };
  return compute(options);
}

void tell_balance(Observer& observer, const BalancedDiagram& balanced) {
  observer.note(
      fmt::format("cells differ from their shares by at most {:.2g}, with a coefficient of variation of {:.2g}",
                  largest_error(balanced), balanced.variation));
  note_misses(observer, balanced);
}

void visit_balance(ObjectVisitor& visitor, const std::optional<BalancedDiagram>& found) {
  const Figures figure(visitor, "balance", found.has_value());
  const BalancedDiagram& balanced = or_none(found);
  figure("converged", "", "whether every cell has its share", balanced.converged);
  figure("variation", "", "root mean square of mass / target - 1", balanced.variation);
  figure("largest_error", "", "largest of |mass / target - 1|", largest_error(balanced));
  figure("diagrams", "", "that were computed", balanced.diagrams);
  figure("tied", "", "sets of cells that have their shares together, but not each",
         each_of(balanced.tied, [](const auto& set) { return each_of(set); }));
  figure("masses", "square mesh units for areas", "of the cells", balanced.masses);
  figure("targets", "as masses", "the shares of the cells", balanced.targets);
}

void tell_diagram(Observer& observer, const Diagram& diagram) {
  const DiagramReport& report = diagram.report;
  observer.note(fmt::format("{}, {}, {} of length {:.6g}", counted(std::ssize(diagram.cells), "cell", "cells"),
                            counted(std::ssize(diagram.branch_points), "branch point", "branch points"),
                            counted(std::ssize(diagram.bisectors), "bisector", "bisectors"), diagram.length));
  if (report.straightened_faces > 0) {
    observer.note(fmt::format(
        "bisectors are straightened in {}; there they are nearer to one generator than to the other by up to {:.3g}",
        counted(report.straightened_faces, "face", "faces"), report.straightened_error));
  }
  if (report.unresolved_ends > 0) {
    observer.note(fmt::format("the diagram is incomplete: {} no branch point",
                              counted(report.unresolved_ends, "end of a bisector has", "ends of bisectors have")));
  }
}

}  // namespace gvd
