#pragma once

#include "gvd/density.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Integrals over a cell.
struct CellMoments {
  double area = 0;    ///< square mesh units
  double mass = 0;    ///< integral of the density; equals the area if that is 1
  double energy = 0;  ///< integral of density times squared distance to the generator, mesh units to the fourth
  /// The mean of the log map at the generator, weighted by the density: the tangent vector to the cell's centroid, mesh
  /// units (see geodesic_tracing.hpp). The gradient of the energy with respect to the generator is -2 mass centroid.
  Vec2 centroid = Vec2::Zero();
};

/// Integrates over every cell of a diagram, with the exact distances and log maps of the polyhedron, whatever the
/// method of the diagram. Distances do not include weights.
///
/// Quadrature: three points in each face, and in each triangle of each piece of a face. The rule is exact for quadratic
/// functions, so it is exact if all paths to a triangle come straight from one image. Triangles crossed by a ridge have
/// an error; a ridge begins at each vertex of positive curvature. On a mesh of 69,451 faces with 100 cells, the energy
/// is accurate to 5e-6, and the centroids to 2e-4 of the mean cell radius (root mean square). If a generator lies on a
/// vertex with curvature, its log map uses the scaled tangent plane, and the mean is not a gradient. `threads` >= 1, or
/// 0 for as many as there are cores; the result does not depend on it.
/// Throws Error{precondition} if the diagram was not made of this mesh. Cost: O(n log n), about half of the cost of the
/// exact diagram.
IdVector<GeneratorId, CellMoments> compute_cell_moments(const Mesh& mesh, const Diagram& diagram, int threads = 0,
                                                        const Density& density = {});

}  // namespace gvd
