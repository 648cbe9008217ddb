#pragma once

#include <vector>

#include "gvd/verify.hpp"
#include "support/brute_force.hpp"

namespace gvd::test {

/// One exact field a generator by gvd::verify. Header only: for the test programs that link it.
inline DistanceFields exact_vertex_fields(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  std::vector<SurfacePoint> vertices;
  for (int v = 0; v < mesh.vertex_count(); ++v) vertices.push_back(vertex_point(mesh, VertexId(v)));
  std::vector<DistanceQuery> queries;
  for (const SurfacePoint& generator : generators) queries.push_back({generator, vertices});
  return compute_exact_distances(mesh, queries);
}

}  // namespace gvd::test
