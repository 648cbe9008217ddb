#pragma once

#include "gvd/mesh.hpp"

namespace gvd::bench {

/// When an edge of the input is kept by an edge of the remesh.
struct KeptCreaseOptions {
  double angle = 40;        ///< degrees between the normals of two faces: sharper edges are creases, of both meshes
  double distance = 0.005;  ///< of the input's midpoint from the remesh's edge, as a fraction of the input's diagonal
  double direction = 20;    ///< degrees between the two edges
};

/// The length of the input's creases that creases of the remesh keep, in percent of all; 100 without creases.
/// An edge counts by its midpoint. Cost: O(n m) for n and m crease edges.
double percent_of_creases_kept(const Mesh& input, const Mesh& remesh, const KeptCreaseOptions& options = {});

}  // namespace gvd::bench
