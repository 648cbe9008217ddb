#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A maximal connected arc of the mesh's boundary that lies in one cell: between two ends of bisectors, or a whole
/// boundary loop.
struct BoundaryArc {
  /// The interval from parameter `begin` to `end` of a boundary halfedge.
  struct Segment {
    HalfedgeId halfedge;
    double begin = 0;
    double end = 1;
  };
  GeneratorId cell;
  std::vector<Segment> segments;
};

/// The point of the arc with the least Euclidean distance from `to`. Cost: O(segments).
SurfacePoint find_nearest_point(const Mesh& mesh, const BoundaryArc& arc, const Vec3& to);

/// The boundary arcs of all cells, loop by loop in the order of their first halfedge. A loop that no generator reaches
/// has none. Cost: O(k log k) for k boundary edges and ends of bisectors.
std::vector<BoundaryArc> list_boundary_arcs(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
