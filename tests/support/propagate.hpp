#pragma once

#include <vector>

#include "geodesic/windows/propagation/propagate_windows.hpp"

namespace gvd::test {

/// The exact distances of these generators.
inline WindowField propagate(const Mesh& mesh, const std::vector<VertexId>& generators,
                             KeepWindows keep = KeepWindows::none, const std::vector<double>& offsets = {}) {
  return propagate_windows(mesh, generators, {keep, offsets}, {});
}

}  // namespace gvd::test
