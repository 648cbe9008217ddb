#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A part of the mesh's boundary that lies in one cell: between two ends of bisectors, or a whole loop.
struct BoundaryRun {
  /// A part of a boundary halfedge, from parameter `begin` to `end`.
  struct Piece {
    HalfedgeId halfedge;
    double begin = 0;
    double end = 1;
  };
  GeneratorId cell;
  std::vector<Piece> pieces;
};

/// The point of a run that is nearest to `to` in a straight line. Cost: O(pieces).
SurfacePoint nearest_point(const Mesh& mesh, const BoundaryRun& run, const Vec3& to);

/// All runs, loop by loop in the order of their first halfedge; loops that no generator reaches have none.
/// Cost: O(k log k) for k boundary edges and ends of bisectors.
std::vector<BoundaryRun> list_boundary_runs(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
