// Weights of the generators of gvd-segment, from files or by balancing the cells (gvd/balance.hpp).
//
// Files of weights and shares have a number for each generator, in their order; the report lists the weights that were
// found, so that --weights gives the same diagram at once.
// Inside regions, the mesh of the diagram has a component for each connected part of one, and the cells of a component
// share out its own area. A density is read for the input: it has a number for each corner of each face, and the faces
// of both meshes are the same.
#include "segment/weights.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "common/balance.hpp"
#include "common/process.hpp"
#include "common/relaxation.hpp"
#include "common/run_parts.hpp"
#include "gvd/balance.hpp"
#include "gvd/error.hpp"
#include "gvd/read_values.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// What a file holds for each generator, and which numbers may be.
struct NumberKind {
  const char* option;
  const char* name;
  const char* range;
  double above;  ///< all numbers are finite and greater
};
constexpr NumberKind kWeights{"--weights", "weight", "finite numbers", -kInfinity};
constexpr NumberKind kShares{"--shares", "share", "finite numbers above 0", 0};

/// A number for each generator, from a file; none without one.
std::vector<double> read_for_generators(const NumberKind& kind, const std::string& file, std::size_t generators) {
  if (file.empty()) return {};
  const std::string name = file == "-" ? kStandardInput : file;
  std::vector<double> values = [&] {
    const WaitForInput wait(file);
    return read_values(file == "-" ? "/dev/stdin" : file);
  }();
  if (values.size() != generators) {
    throw Error(
        ErrorCode::unreadable_input,
        fmt::format("{}: {} for {}; {} takes one for each", name, counted(std::ssize(values), "number", "numbers"),
                    counted(std::ptrdiff_t(generators), "generator", "generators"), kind.option));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > kind.above && values[i] < kInfinity) continue;
    throw Error(ErrorCode::precondition,
                fmt::format("{}: the {} of generator {} is {}; give {}", name, kind.name, i, values[i], kind.range),
                std::int64_t(i));
  }
  return values;
}

Diagram balance(Run& run, const DiagramSurface& surface, const std::vector<SurfacePoint>& generators,
                const WeightOptions& options, BalanceOptions balancing) {
  if (options.balance != "area") balancing.density = find_density(run, surface.input, "--balance", options.balance);
  balancing.shares = read_for_generators(kShares, options.shares, generators.size());
  balancing.diagram.progress = run.progress();
  BalancedDiagram balanced = run.timed("balance", [&] { return balance_cells(surface.mesh, generators, balancing); });
  report_diagram(run, balanced.diagram);
  report_balance(run, balanced);
  return std::move(balanced.diagram);
}

}  // namespace

void describe(OptionList& list, WeightOptions& options, const ComputeOptions& compute) {
  list.option(
      "balance", ValueSource{&options.balance, {"area"}},
      {.help = "Make all cells equal by weights of their generators",
       .more = ": in area, or in the integral of a number for each vertex or face, out of a file or a property of "
               "{option:input}"});
  list.option("shares", File{&options.shares},
              {.help = "With {option:balance}, the share of each generator, in any unit",
               .more = "; - is standard input",
               .usual = "equal"});
  list.option("weights", File{&options.weights},
              {.help = "Make the distances of each generator longer by its number in FILE",
               .more = "; - is standard input",
               .unit = "mesh units"});
  list.needs("shares", "balance");
  for (const char* name : {"balance", "weights"}) {
    list.rule({name, {"method"}, [&compute, name](const Given&) {
                 return compute.diagram.method == Method::exact
                            ? ""
                            : fmt::format("{{option:{}}} needs {{option:method=exact}}", name);
               }});
  }
}

Diagram build_weighted_diagram(Run& run, const DiagramSurface& surface, const std::vector<SurfacePoint>& generators,
                               const WeightOptions& options) {
  if (options.balance.empty() && options.weights.empty()) return build_diagram(run, surface.mesh, generators);
  BalanceOptions balancing;
  balancing.diagram = run.options().compute.diagram;
  balancing.diagram.weights = read_for_generators(kWeights, options.weights, generators.size());
  Diagram diagram = options.balance.empty() ? build_diagram(run, surface.mesh, generators, balancing.diagram.weights)
                                            : balance(run, surface, generators, options, balancing);
  run.report().results()["weights"] = diagram.weights;
  return diagram;
}

}  // namespace gvd::app
