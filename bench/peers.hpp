#pragma once

#include <vector>

#include "gvd/mesh.hpp"

namespace gvd::bench {

/// Processor times in milliseconds of CGAL's distances to the nearest generator, at every vertex. Neither method yields
/// labels or bisectors.
struct PeerTimes {
  double shortest_paths = 0;  ///< Surface_mesh_shortest_path, exact: the sequence tree and a query for each vertex
  double heat = 0;            ///< Heat_method_3, approximate: the factorisation and one solution
  double heat_again = 0;      ///< one more solution with the same factorisation
};

/// Throws gvd::Error if CGAL can't represent the mesh.
PeerTimes time_peers(const Mesh& mesh, const std::vector<VertexId>& generators);

/// The heat method's distances of all vertices from each generator, in mesh units: one list for each generator.
/// Throws gvd::Error where CGAL can't hold the mesh.
std::vector<std::vector<double>> compute_heat_distances(const Mesh& mesh, const std::vector<VertexId>& generators);

/// The surface with near-equilateral triangles whose edges have about this length, mesh units: vertices lie on it.
/// `rounds`: of splits, collapses, flips and a relaxation each. Throws gvd::Error where CGAL can't hold the mesh.
Mesh remesh_isotropically(const Mesh& mesh, double edge_length, unsigned rounds);

}  // namespace gvd::bench
