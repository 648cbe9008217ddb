#pragma once

#include <vector>

#include "state/relaxation_state.hpp"

namespace gvd::test {

/// The state of these generators with their exact diagram.
inline RelaxationState evaluate_state(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return evaluate_generators(mesh, generators, {});
}

}  // namespace gvd::test
