// Options, steps, notes and figures that the operations that make diagrams share.
//
// Weights of generators are given, or found by balancing the cells (gvd/balance.hpp). Inside regions, the mesh of the
// diagram has a component for each connected part of a region, and the cells of a component divide up its own area. The
// density of the input also serves for the diagram's mesh, because it has a number for each corner of each face, and
// both meshes have the same faces.

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
#include "gvd/error.hpp"
#include "gvd/read_values.hpp"
#include "gvd/relaxation_parts.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// A note names at most this many cells.
constexpr std::size_t kNamedCells = 8;

double largest_error(const BalancedDiagram& balanced) {
  double largest = 0;
  for (std::size_t i = 0; i < balanced.masses.size(); ++i) {
    largest = std::max(largest, std::abs(balanced.masses[i] / balanced.targets[i] - 1));
  }
  return largest;
}

/// Notes which cells missed their share, and why.
void note_misses(Observer& observer, const BalancedDiagram& balanced) {
  std::vector<std::int32_t> cells;
  for (const auto& set : balanced.tied) {
    for (const GeneratorId g : set) cells.push_back(g.value());
  }
  if (!cells.empty()) {
    const auto named = cells.begin() + static_cast<std::ptrdiff_t>(std::min(kNamedCells, cells.size()));
    observer.note(fmt::format("{}: {}{}; try other generators",
                              counted(std::ssize(cells), "cell missed its share, which no weights can reach",
                                      "cells missed their shares, which no weights can reach"),
                              fmt::join(cells.begin(), named, ", "), named == cells.end() ? "" : ", ..."));
  }
  if (!balanced.converged) {
    observer.note(
        fmt::format("balancing ended after {} diagrams, before all cells had their shares", balanced.diagrams));
  }
}

/// A kind of numbers that generators have, and the range of these numbers.
struct NumberKind {
  const char* option;
  const char* name;
  const char* range;
  double above;  ///< numbers must be finite and greater than this
};
constexpr NumberKind kWeights{"\1weights\2", "weight", "finite numbers", -kInfinity};
constexpr NumberKind kShares{"\1shares\2", "share", "finite numbers above 0", 0};

/// The given number of each generator; empty if none is given.
std::vector<double> numbers_of(const NumberKind& kind, const GivenNumbers& given, std::size_t generators) {
  if (!given.values) return {};
  const std::vector<double>& values = given.values->soup.values;
  const std::string& title = given.values->title;
  if (values.size() != generators) {
    throw Error(
        given.name.empty() ? ErrorCode::invalid_option : ErrorCode::unreadable_input,  // an array or a file
        fmt::format("{}: {} for {}; {} takes one for each", title, counted(std::ssize(values), "number", "numbers"),
                    counted(std::ptrdiff_t(generators), "generator", "generators"), kind.option));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > kind.above && values[i] < kInfinity) continue;
    throw Error(ErrorCode::precondition,
                fmt::format("{}: the {} of generator {} is {}; give {}", title, kind.name, i, values[i], kind.range),
                std::int64_t(i));
  }
  return values;
}

Diagram compute_weighted(const CheckedMesh& input, const Mesh& surface, const std::vector<SurfacePoint>& generators,
                         const DiagramParts& parts, Observer& observer, std::optional<BalancedDiagram>& balanced) {
  const GivenWeights& weights = parts.weights;
  BalanceOptions balancing;
  balancing.diagram = parts.diagram;
  balancing.diagram.weights = numbers_of(kWeights, weights.weights, generators.size());
  if (!weights.balance.is_given()) {
    Diagram made = compute_in_steps(observer, balancing.diagram, [&](const DiagramOptions& stepped) {
      return compute_diagram(surface, generators, stepped);
    });
    tell_diagram(observer, made);
    return made;
  }
  balancing.density = find_density(input, weights.balance);
  balancing.shares = numbers_of(kShares, weights.shares, generators.size());
  balancing.diagram.progress = progress_of(observer);
  balanced = as_step(observer, "balance", [&] { return balance_cells(surface, generators, balancing); });
  tell_diagram(observer, balanced->diagram);
  tell_balance(observer, *balanced);
  return std::exchange(balanced->diagram, {});
}

void needs_exact_method(OptionList& list, const char* name, const DiagramOptions& diagram) {
  list.rule({name, {"method"}, [&diagram, name](const Given&) {
               return diagram.method == Method::exact ? "" : fmt::format("\1{}\2 needs \1method=exact\2", name);
             }});
}

}  // namespace

void describe(OptionList& list, GivenWeights& weights, const DiagramOptions& diagram) {
  using Of = ValueSource::Of;
  describe_balance(list, weights.balance, "Balance the cells by weights of their generators", diagram);
  list.option("shares", ValueSource{&weights.shares, {}, Of::generators},
              {.help = "With \1balance\2, the share of each generator, in any unit", .usual = "equal"});
  list.option("weights", ValueSource{&weights.weights, {}, Of::generators},
              {.help = "Add each generator's number in FILE to its distances",
               .arrays = "Add each generator's number to its distances",
               .unit = "mesh units"});
  list.needs("shares", "balance");
  needs_exact_method(list, "weights", diagram);
}

void describe_balance(OptionList& list, GivenNumbers& balance, const std::string& help, const DiagramOptions& diagram) {
  list.option(
      "balance", ValueSource{&balance, {"area"}},
      {.help = help,
       .more = ": in area, or in the integral of a number for each vertex or face, from a file or a property of "
               "the input",
       .arrays = help + ": in area ('area'), or in the integral of a number for each vertex or face"});
  needs_exact_method(list, "balance", diagram);
}

void describe_curve_rules(OptionList& list, const DiagramOptions& diagram) {
  list.excludes("curves", {"sampling", "seed", "merge_coincident"});
  list.excludes("curves", {"balance", "weights"}, "bisectors with weights are computed between points alone");
  list.excludes("curves", {"within", "mask"}, "a curve may leave its region");
  list.rule({"curves", {"method"}, [&diagram](const Given&) -> std::string {
               return diagram.method == Method::exact ? "" : "\1curves\2 needs \1method=exact\2";
             }});
}

Diagram compute_parts(const CheckedMesh& input, PartedMesh& parted, const DiagramParts& parts, bool each,
                      Observer& observer, ResolvedGenerators& found, std::optional<BalancedDiagram>& balanced) {
  if (parts.generators.curves.is_given()) {
    const std::vector<GeneratorCurve> curves = choose_curves(input, parts.generators, observer);
    Diagram made = compute_in_steps(observer, parts.diagram, [&](const DiagramOptions& stepped) {
      return compute_diagram(input.mesh, curves, stepped);
    });
    tell_diagram(observer, made);
    return made;
  }
  found = choose_inside(input, parted, parts.generators, parts.diagram, each, observer);
  return compute_weighted(input, parted.surface(input.mesh), found.points, parts, observer, balanced);
}

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
  observer.note(fmt::format("the largest error of a cell's share is {:.2g}; the coefficient of variation is {:.2g}",
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
        "bisectors are straightened in {}; there, the distances to their two generators differ by up to {:.3g}",
        counted(report.straightened_faces, "face", "faces"), report.straightened_error));
  }
  if (report.unresolved_ends > 0) {
    observer.note(fmt::format("the diagram is incomplete: {} no branch point",
                              counted(report.unresolved_ends, "end of a bisector has", "ends of bisectors have")));
  }
}

}  // namespace gvd
