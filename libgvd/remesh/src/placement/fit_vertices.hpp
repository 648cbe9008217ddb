#pragma once

#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/mesh.hpp"
#include "placement/surface_samples.hpp"

namespace gvd {

/// A spring that holds a vertex near a position, in each direction with a strength of its own.
struct VertexAnchor {
  Vec3 position;
  Eigen::Matrix3d weight = Eigen::Matrix3d::Zero();  ///< square mesh units, positive definite
};

/// The surface that a mesh is fitted to.
struct FitTarget {
  const Mesh* surface = nullptr;
  const ClosestPointTree* tree = nullptr;  ///< of the surface
  std::vector<SurfaceSample> samples;      ///< of the surface
  double count = 0;                        ///< of samples of the mesh
  int threads = 0;
};

/// The vertex positions with the least sum of three terms. Two are the square distances of samples of a surface from
/// a mesh, and of samples of the mesh from the surface. The third is the stretch of the springs.
///
/// A pair of a sample and its closest point counts by a plane through one of them, normal to the direction to the
/// other. It is the plane of a triangle, or one that touches an edge or a vertex. The pairs are those of the mesh
/// before. Pairs of faces that look in opposite directions do not count: they belong to different sheets. `anchors`:
/// one for each vertex. Gives the positions before where the system can't be solved.
/// Cost: O(n log n), and a sparse Cholesky factorisation.
std::vector<Vec3> fit_vertices(const Mesh& remesh, const FitTarget& target, const std::vector<VertexAnchor>& anchors);

}  // namespace gvd
