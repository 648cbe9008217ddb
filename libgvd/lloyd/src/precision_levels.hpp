#pragma once

#include <cstddef>
#include <vector>

#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The diagrams of a relaxation: those that it begins with first, those of `options.diagram` last. Energies of
/// different levels must not be compared with each other: they differ by the errors of the distances.
std::vector<DiagramOptions> make_precision_levels(const Mesh& mesh, std::size_t generators,
                                                  const LloydOptions& options);

}  // namespace gvd
