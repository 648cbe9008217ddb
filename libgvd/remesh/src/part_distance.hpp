#pragma once

#include "gvd/mesh.hpp"

namespace gvd {

/// Distances between a part of a surface and its remesh, both ways, mesh units.
struct PartDistance {
  double rms = 0;
  double largest = 0;  ///< of a sample

  /// Whether this is no farther than another, by both measures.
  bool is_within(const PartDistance& other) const;
};

/// Measures distances at samples of both meshes, about sixteen for each vertex of the remesh and at least one in each
/// face. For decisions between placements, not for reports. Deterministic. Cost: O(n log n).
PartDistance measure_part_distance(const Mesh& surface, const Mesh& remesh);

}  // namespace gvd
