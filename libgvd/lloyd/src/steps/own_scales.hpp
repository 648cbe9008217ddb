#pragma once

#include <functional>
#include <vector>

#include "constraints/generator_constraints.hpp"
#include "integrals/cell_integrals.hpp"
#include "state/relaxation_state.hpp"

namespace gvd {

/// For each generator the largest factor of its way to the centroid, out of `step`, step / 2, step / 4, ... and 0, that
/// lowers the energy of its cell while the cell stays fixed. The diagram of the moved generators has at most the energy
/// of these fixed cells, up to the errors of the distances. `report` is called before each generator.
/// Cost: up to eleven times the integrals of every cell.
std::vector<double> find_own_scales(const GeneratorConstraints& constraints, const RelaxationState& state, double step,
                                    CellIntegrals& integrals, const std::function<void()>& report);

}  // namespace gvd
