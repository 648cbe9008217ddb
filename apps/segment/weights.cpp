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

#include "common/run_observer.hpp"
#include "common/run_parts.hpp"
#include "gvd/balance.hpp"
#include "gvd/error.hpp"
#include "gvd/read_values.hpp"
#include "gvd/relaxation_parts.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

/// What a file holds for each generator, and which numbers may be.
struct NumberKind {
  const char* option;
  const char* name;
  const char* range;
  double above;  ///< all numbers are finite and greater
};
constexpr NumberKind kWeights{"--weights", "weight", "finite numbers", -kInfinity};
constexpr NumberKind kShares{"--shares", "share", "finite numbers above 0", 0};

/// A number for each generator; none where none is given.
std::vector<double> read_for_generators(const NumberKind& kind, const GivenNumbers& given, std::size_t generators) {
  if (!given.values) return {};
  const std::vector<double>& values = given.values->soup.values;
  const std::string& file = given.values->title;
  if (values.size() != generators) {
    throw Error(
        ErrorCode::unreadable_input,
        fmt::format("{}: {} for {}; {} takes one for each", file, counted(std::ssize(values), "number", "numbers"),
                    counted(std::ptrdiff_t(generators), "generator", "generators"), kind.option));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > kind.above && values[i] < kInfinity) continue;
    throw Error(ErrorCode::precondition,
                fmt::format("{}: the {} of generator {} is {}; give {}", file, kind.name, i, values[i], kind.range),
                std::int64_t(i));
  }
  return values;
}

/// The figures of a balanced diagram.
class BalanceFigures : public Object {
 public:
  explicit BalanceFigures(const BalancedDiagram& balanced) : balanced_(balanced) {}
  std::string_view kind() const override { return "balance"; }
  void visit(ObjectVisitor& visitor) const override { visit_balance(visitor, &balanced_); }

 private:
  const BalancedDiagram& balanced_;
};

Diagram balance(Run& run, const DiagramSurface& surface, const std::vector<SurfacePoint>& generators,
                const WeightOptions& options, BalanceOptions balancing) {
  balancing.density = find_density(surface.input, options.balance);
  balancing.shares = read_for_generators(kShares, options.shares, generators.size());
  balancing.diagram.progress = run.progress();
  BalancedDiagram balanced = run.timed("balance", [&] { return balance_cells(surface.mesh, generators, balancing); });
  report_diagram(run, balanced.diagram);
  RunObserver observer(run);
  tell_balance(observer, balanced);
  report_figures(run, BalanceFigures(balanced));
  return std::move(balanced.diagram);
}

}  // namespace

void describe(OptionList& list, WeightOptions& options, const ComputeOptions& compute) {
  list.option(
      "balance", ValueSource{&options.balance, {"area"}},
      {.help = "Make all cells equal by weights of their generators",
       .more = ": in area, or in the integral of a number for each vertex or face, out of a file or a property of "
               "{option:input}"});
  list.option("shares", ValueSource{&options.shares, {}, ValueSource::Of::generators},
              {.help = "With {option:balance}, the share of each generator, in any unit", .usual = "equal"});
  list.option("weights", ValueSource{&options.weights, {}, ValueSource::Of::generators},
              {.help = "Make the distances of each generator longer by its number in FILE", .unit = "mesh units"});
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
  if (!options.balance.is_given() && !options.weights.is_given()) return build_diagram(run, surface.mesh, generators);
  BalanceOptions balancing;
  balancing.diagram = run.options().compute.diagram;
  balancing.diagram.weights = read_for_generators(kWeights, options.weights, generators.size());
  Diagram diagram = !options.balance.is_given() ? build_diagram(run, surface.mesh, generators, balancing.diagram.weights)
                                            : balance(run, surface, generators, options, balancing);
  run.report().results()["weights"] = diagram.weights;
  return diagram;
}

}  // namespace gvd::app
