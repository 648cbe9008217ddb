#pragma once

#include <algorithm>

#include "gvd/mesh.hpp"

namespace gvd::test {

/// The edge between two vertices; invalid where there is none. Cost: O(n).
inline EdgeId edge_between(const Mesh& mesh, int u, int v) {
  for (int i = 0; i < mesh.edge_count(); ++i) {
    const HalfedgeId h = mesh.halfedge(EdgeId(i));
    if (std::minmax({mesh.from(h).value(), mesh.to(h).value()}) == std::minmax({u, v})) return EdgeId(i);
  }
  return EdgeId();
}

}  // namespace gvd::test
