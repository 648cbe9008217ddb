#pragma once

#include <variant>
#include <vector>

#include "diagram/diagram_windows.hpp"
#include "gvd/balance.hpp"

namespace gvd {

/// Integrals of the density over the cells of a diagram, exactly for what is linear in each face. Cost: O(n).
std::vector<double> compute_cell_masses(const Mesh& mesh, const Diagram& diagram, const Density& density);

/// `balance_cells`, but where the weights of the options leave a generator without a cell, returns it.
std::variant<BalancedDiagram, HiddenGenerator> try_to_balance(const Mesh& mesh,
                                                              const std::vector<SurfacePoint>& generators,
                                                              const BalanceOptions& options);

}  // namespace gvd
