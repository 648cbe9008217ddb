#pragma once

#include <utility>
#include <vector>

#include "diagram/graph/nearest_labels.hpp"
#include "diagram/growth/rough_bisectors.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd::test {

/// The first steps of a diagram, each as the next one gets it. The mesh must outlive it.
struct Stages {
  Stages(const Mesh& input, const std::vector<SurfacePoint>& generators, Front which)
      : front(which),
        working(input, generators),
        marched(march(working, which, {})),
        labels(compute_nearest_labels(working, marched.table)),
        rough(find_rough_crossings(working, marched.table, labels, which)) {}

  const Mesh& mesh() const { return working.mesh(); }
  const GeneratorTable& table() const { return marched.table; }

  Front front;
  WorkingMesh working;
  FastMarchingResult marched;
  NearestLabels labels;
  Crossings rough;
};

/// The vertices with these ids as generators.
inline std::vector<SurfacePoint> at_vertices(const Mesh& mesh, const std::vector<int>& ids) {
  std::vector<SurfacePoint> points;
  for (const int id : ids) points.push_back(vertex_point(mesh, VertexId(id)));
  return points;
}

inline const char* name(Front front) { return front == Front::circle ? "circle" : "planar"; }

}  // namespace gvd::test
