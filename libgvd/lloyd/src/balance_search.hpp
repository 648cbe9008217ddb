#pragma once

#include <variant>
#include <vector>

#include "diagram/diagram_windows.hpp"
#include "gvd/balance.hpp"

namespace gvd {

/// Integrates the density, which is linear in each face, exactly over the cells of a diagram. Cost: O(n).
std::vector<double> compute_cell_masses(const Mesh& mesh, const Diagram& diagram, const Density& density);

/// Does the same as `balance_cells`, but if the initial weights leave a generator without a cell, returns this
/// generator.
std::variant<BalancedDiagram, HiddenGenerator> try_to_balance(const Mesh& mesh,
                                                              const std::vector<SurfacePoint>& generators,
                                                              const BalanceOptions& options);

}  // namespace gvd
