#pragma once

#include <vector>

#include "gvd/lloyd.hpp"

namespace gvd {

/// How the cells are measured, and when an iteration is not worth its time.
struct RelaxerRules {
  bool starts_by_faces = true;  ///< measure the cells face by face first; only for accelerated runs with Method::exact
  bool ends_by_faces = false;   ///< measure the cells face by face to the end; the result has no diagram
  /// Stop if moving all generators to their centroids promises to lower the energy by less than this fraction, with
  /// unchanged borders of the cells. >= 0.
  double least_promise = 0;
};

/// Does the iterations of `relax_generators` on a mesh, which may be the copy. The options must have been checked, and
/// there must be generators.
/// Throws Error{interrupted} and Error{precondition} as `relax_generators` does.
LloydResult relax_on_mesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LloydOptions& options,
                          const RelaxerRules& rules);

}  // namespace gvd
