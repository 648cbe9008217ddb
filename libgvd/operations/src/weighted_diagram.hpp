#pragma once

#include <optional>
#include <vector>

#include "gvd/balance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/observer.hpp"
#include "gvd/segment_operation.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

void describe(OptionList& list, GivenWeights& weights, const DiagramOptions& diagram);

/// Curves have neither weights nor regions: says why.
void exclude_curves(OptionList& list);

/// Computes the diagram on `surface`, which has the faces of the input, balanced where that is asked for; `balanced`
/// then has the rest of what is known. Throws what compute_diagram and balance_cells throw, and Error{precondition}
/// where there is not one number for each generator, or one is out of its range.
Diagram compute_weighted(const CheckedMesh& input, const Mesh& surface, const std::vector<SurfacePoint>& generators,
                         const GivenWeights& weights, const DiagramOptions& options, Observer& observer,
                         std::optional<BalancedDiagram>& balanced);

/// The diagram of the curves that are given as generators. Throws what choose_curves and compute_diagram throw.
Diagram compute_of_curves(const CheckedMesh& input, const GeneratorOptions& generators, const DiagramOptions& options,
                          Observer& observer);

}  // namespace gvd
