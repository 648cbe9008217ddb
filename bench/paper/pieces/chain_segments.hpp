#pragma once

#include <cstdint>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::paper {

/// A straight piece of a bisector in one face: from `begin` to `end` the cell `left` is on the left.
struct Segment {
  GeneratorId left, right;
  SurfacePoint begin, end;
};

/// Ends of segments closer than this are one point: a fraction of the bounding box's diagonal.
inline constexpr double kSameEnd = 1e-9;

struct Chains {
  std::vector<Bisector> bisectors;
  std::int64_t open_ends = 0;  ///< points inside the mesh at which a single segment ends
};

/// Joins segments between the same two cells to polylines. A chain ends where other cells are, on the boundary, or
/// where nothing continues it. Cost: O(k log k) for k segments.
Chains chain_segments(const Mesh& mesh, const std::vector<Segment>& segments);

}  // namespace gvd::paper
