// Weights of generators: given ones, or those by which the cells are balanced (gvd/balance.hpp).
//
// Inside regions, the mesh of the diagram has a component for each connected part of one, and the cells of a component
// share out its own area. A density is that of the input: it has a number for each corner of each face, and the faces
// of both meshes are the same.

#include "weighted_diagram.hpp"

#include <fmt/format.h>

#include <utility>

#include "gvd/diagram_parts.hpp"
#include "gvd/error.hpp"
#include "gvd/read_values.hpp"
#include "gvd/relaxation_parts.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// What there is for each generator, and which numbers may be.
struct NumberKind {
  const char* option;
  const char* name;
  const char* range;
  double above;  ///< all numbers are finite and greater
};
constexpr NumberKind kWeights{"\1weights\2", "weight", "finite numbers", -kInfinity};
constexpr NumberKind kShares{"\1shares\2", "share", "finite numbers above 0", 0};

/// A number for each generator; none where none is given.
std::vector<double> numbers_of(const NumberKind& kind, const GivenNumbers& given, std::size_t generators) {
  if (!given.values) return {};
  const std::vector<double>& values = given.values->soup.values;
  const std::string& title = given.values->title;
  if (values.size() != generators) {
    throw Error(
        given.name.empty() ? ErrorCode::invalid_option : ErrorCode::unreadable_input,  // an array, or a file
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

}  // namespace

void describe(OptionList& list, GivenWeights& weights, const DiagramOptions& diagram) {
  using Of = ValueSource::Of;
  list.option(
      "balance", ValueSource{&weights.balance, {"area"}},
      {.help = "Make all cells equal by weights of their generators",
       .more = ": in area, or in the integral of a number for each vertex or face, out of a file or a property of "
               "the input",
       .arrays = "Make all cells equal by weights of their generators: in area ('area'), or in the integral of a "
                 "number for each vertex or face"});
  list.option("shares", ValueSource{&weights.shares, {}, Of::generators},
              {.help = "With \1balance\2, the share of each generator, in any unit", .usual = "equal"});
  list.option("weights", ValueSource{&weights.weights, {}, Of::generators},
              {.help = "Make the distances of each generator longer by its number in FILE",
               .arrays = "Make the distances of each generator longer by its number",
               .unit = "mesh units"});
  list.needs("shares", "balance");
  for (const char* name : {"balance", "weights"}) {
    list.rule({name, {"method"}, [&diagram, name](const Given&) {
                 return diagram.method == Method::exact ? "" : fmt::format("\1{}\2 needs \1method=exact\2", name);
               }});
  }
}

void exclude_curves(OptionList& list) {
  list.excludes("curves", {"balance", "weights"}, "bisectors with weights are computed between points alone");
  list.excludes("curves", {"within", "mask"}, "a curve may leave its region");
}

Diagram compute_weighted(const CheckedMesh& input, const Mesh& surface, const std::vector<SurfacePoint>& generators,
                         const GivenWeights& weights, const DiagramOptions& options, Observer& observer,
                         std::optional<BalancedDiagram>& balanced) {
  BalanceOptions balancing;
  balancing.diagram = options;
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

Diagram compute_of_curves(const CheckedMesh& input, const GeneratorOptions& generators, const DiagramOptions& options,
                          Observer& observer) {
  const std::vector<GeneratorCurve> curves = choose_curves(input, generators, observer);
  Diagram made = compute_in_steps(
      observer, options, [&](const DiagramOptions& stepped) { return compute_diagram(input.mesh, curves, stepped); });
  tell_diagram(observer, made);
  return made;
}

}  // namespace gvd
