#pragma once

#include <map>
#include <utility>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A generator on an edge: at (1 - t) from(halfedge) + t to(halfedge), where `halfedge` is the edge's first one.
struct EdgeGenerator {
  HalfedgeId halfedge;
  double t;  ///< in ]0, 1[
  GeneratorId generator;
};

/// Generators by what they lie on.
struct SortedGenerators {
  std::vector<std::pair<VertexId, GeneratorId>> on_vertices;  ///< ascending by generator
  std::vector<EdgeGenerator> on_edges;                        ///< ascending by (halfedge, t, generator)
  std::map<FaceId, std::vector<GeneratorId>> in_faces;        ///< per face ascending by generator
};

/// Throws Error{precondition} where there is no generator or the face of one does not exist. Cost: O(n log n).
SortedGenerators sort_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

}  // namespace gvd
