#pragma once

#include <string>
#include <vector>

#include "common/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/option_list.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// Weights of the generators: given ones, and those by which the cells have their shares.
namespace gvd::app {

struct WeightOptions {
  GivenNumbers balance;  ///< "area", or a number for each vertex or face; none: cells as they come
  GivenNumbers shares;   ///< of the generators; none: equal ones
  GivenNumbers weights;  ///< of the generators, for --balance to start from
};

/// Describes them. `compute` tells whether the method takes weights; both must outlive the list.
void describe(OptionList& list, WeightOptions& options, const ComputeOptions& compute);

/// The input of a command, and the mesh of the diagram, which has the same faces.
struct DiagramSurface {
  const CheckedMesh& input;
  const Mesh& mesh;
};

/// Computes the diagram by the options, balanced where they say so, and reports it. Throws what `build_diagram`,
/// read_values, read_density and balance_cells throw.
Diagram build_weighted_diagram(Run& run, const DiagramSurface& surface, const std::vector<SurfacePoint>& generators,
                               const WeightOptions& options);

}  // namespace gvd::app
