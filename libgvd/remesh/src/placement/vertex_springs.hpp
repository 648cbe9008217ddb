#pragma once

#include <vector>

#include "gvd/mesh.hpp"
#include "placement/crease_cells.hpp"
#include "placement/fit_vertices.hpp"

namespace gvd {

/// What a vertex may do in the rounds of a fit.
enum class VertexRole : char {
  free,         ///< goes along the surface to where its triangles are good
  near_crease,  ///< a neighbour of vertices at creases: nothing but the samples moves it along the surface
  at_crease,    ///< goes across the crease to where its triangles meet it
  held,         ///< stays where the rounds begin: at its generator if fixed, else at the boundary's quadric minimum
};

/// What the springs of the vertices depend on, beside their positions.
struct SpringPlan {
  const Mesh* remesh = nullptr;  ///< with its vertices at the generators
  IdVector<GeneratorId, CreaseCell> creases;
  std::vector<VertexRole> roles;
  std::vector<double> areas;  ///< of the cells, > 0, square mesh units
};

/// The roles of the vertices: `held` ones, those at creases, their neighbours, and the rest. Cost: O(n).
std::vector<VertexRole> find_vertex_roles(const Mesh& remesh, const IdVector<GeneratorId, CreaseCell>& creases,
                                          const std::vector<char>& held);

/// The springs for a round of the fit that starts with the vertices of `current`. Cost: O(n).
std::vector<VertexAnchor> make_springs(const Mesh& current, const SpringPlan& plan);

}  // namespace gvd
