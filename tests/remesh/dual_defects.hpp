#pragma once

#include <vector>

#include "gvd/dual.hpp"

namespace gvd::test {

/// The defects of a diagram's dual.
inline std::vector<DualDefect> find_dual_defects(const Mesh& mesh, const Diagram& diagram) {
  return check_dual(mesh, diagram, build_dual(mesh, diagram));
}

}  // namespace gvd::test
