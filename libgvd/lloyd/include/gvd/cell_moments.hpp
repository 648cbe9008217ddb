#pragma once

#include "gvd/density.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Integrals over one cell.
struct CellMoments {
  double area = 0;    ///< square mesh units
  double mass = 0;    ///< integral of the density; the area where that is 1
  double energy = 0;  ///< integral of density times squared distance to the generator, mesh units to the fourth
  /// Mean of the log map, weighted by the density, at the generator: the tangent vector to the cell's centroid, mesh
  /// units (see geodesic_tracing.hpp). The energy's gradient with respect to the generator is -2 mass centroid.
  Vec2 centroid = Vec2::Zero();
};

/// Integrals over every cell of a diagram, with the exact distances and log maps of the polyhedron, however the diagram
/// was made. With weights, distances are those from the generators, without the weights.
///
/// Quadrature: three points in each face, and in each triangle of each piece of a face. The rule is exact for
/// quadratic functions, so where all paths to a triangle come straight from one image. A triangle crossed by a ridge,
/// which begins at each vertex of positive curvature, has an error. On a mesh of 69,451 faces with 100 cells the energy
/// is right to 5e-6, the centroids to 2e-4 of the mean cell radius (root mean square).
/// At a generator on a vertex with curvature, the log map is that of the scaled tangent plane, and its mean is no
/// gradient. `threads` >= 1, or 0 for one a core: the result does not depend on it.
/// Throws Error{precondition} if the diagram was not made of this mesh. Cost: O(n log n), some half of that of the exact
/// diagram.
IdVector<GeneratorId, CellMoments> compute_cell_moments(const Mesh& mesh, const Diagram& diagram, int threads = 0,
                                                        const Density& density = {});

}  // namespace gvd
