// Alternately balances the cells and moves generators to their centroids.
//
// A move of the generators changes the masses of their cells only a little. So each round starts from the weights of
// the previous round, and needs three to five diagrams. If these weights hide a generator at its new place, the round
// starts without weights.
// Invariant: the result is balanced; no generator moves after balancing.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "balance_search.hpp"
#include "constraints.hpp"
#include "generator_moves.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Balances the cells, starting from these weights if they leave every generator a cell.
BalancedDiagram balance_from(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const BalanceOptions& options, const std::vector<double>& weights) {
  if (!weights.empty()) {
    BalanceOptions from = options;
    from.diagram.weights = weights;
    auto balanced = try_to_balance(mesh, generators, from);
    if (auto* const found = std::get_if<BalancedDiagram>(&balanced)) return std::move(*found);
  }
  return balance_cells(mesh, generators, options);
}

double mean_cell_radius(const Diagram& diagram) {
  double area = 0;
  for (const Cell& cell : diagram.cells) area += cell.area;
  return std::sqrt(area / (std::numbers::pi * double(diagram.cells.size())));
}

}  // namespace

BalancedRelaxation relax_balanced(const Mesh& mesh, std::vector<SurfacePoint> generators,
                                  const BalancedRelaxationOptions& options) {
  if (options.max_rounds < 0) throw Error(ErrorCode::invalid_option, "the number of rounds must not be negative");
  if (!(options.move_tolerance >= 0)) throw Error(ErrorCode::invalid_option, "the move tolerance must be 0 or more");
  const GeneratorConstraints constraints(mesh, options.freedom, options.creases);
  constraints.check(generators);
  BalancedRelaxation result;
  while (true) {
    result.balanced = balance_from(mesh, generators, options.balance, result.balanced.diagram.weights);
    result.diagrams += result.balanced.diagrams;
    result.moments =
        compute_cell_moments(mesh, result.balanced.diagram, options.balance.diagram.threads, options.density);
    result.mean_cell_radius = mean_cell_radius(result.balanced.diagram);
    RelaxationState state;
    state.generators = generators;
    state.mean_cell_radius = result.mean_cell_radius;
    TangentField steps;
    result.residual = 0;
    for (const GeneratorId g : result.moments.ids()) {
      steps.push_back(constraints.project(mesh, g.index(), generators[g.index()], result.moments[g].centroid));
      result.residual = std::max(result.residual, steps.back().norm());
    }
    if (result.rounds == options.max_rounds) return result;
    if (result.residual <= options.move_tolerance * result.mean_cell_radius) return result;
    generators = move_generators(mesh, state, steps, constraints).to;
    ++result.rounds;
  }
}

}  // namespace gvd
