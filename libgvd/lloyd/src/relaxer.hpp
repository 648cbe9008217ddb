#pragma once

#include <vector>

#include "gvd/lloyd.hpp"

namespace gvd {

/// How the cells are found, and when an iteration is not worth its time.
struct RelaxerRules {
  bool starts_by_faces = true;  ///< measures the cells face by face first; accelerated runs with Method::exact do
  bool ends_by_faces = false;   ///< does so to the end, and the result has no diagram
  /// Stop where the way to the centroids promises to lower the energy by less than this fraction of it, if all cells
  /// kept their borders. >= 0.
  double least_promise = 0;
};

/// The iterations of relax_generators on one mesh, which may be the copy. The options have been checked, and there are
/// generators.
/// Throws Error{interrupted} and Error{precondition} as relax_generators does.
LloydResult relax_on_mesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LloydOptions& options,
                          const RelaxerRules& rules);

}  // namespace gvd
