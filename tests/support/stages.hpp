#pragma once

#include <utility>
#include <vector>

#include "diagram/graph/connected_tracer.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "diagram/growth/gap_tracer.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd::test {

/// The results of the first steps of a diagram. The mesh must outlive it.
struct Stages {
  Stages(const Mesh& input, const std::vector<SurfacePoint>& generators, Front which)
      : front(which),
        working(input, generators),
        marched(march(working, which, {})),
        labels(compute_nearest_labels(working, marched.table)),
        rough(find_rough_crossings({working, marched.table, labels, which})) {}

  const Mesh& mesh() const { return working.mesh(); }
  const GeneratorTable& table() const { return marched.table; }
  GrowthInput input() const { return {working, marched.table, labels, front}; }

  Front front;
  WorkingMesh working;
  FastMarchingResult marched;
  NearestLabels labels;
  Crossings rough;
};

/// The traced diagram of the growth tracer, on the tables of a march.
inline TracedDiagram trace_growth(const WorkingMesh& working, const GeneratorTable& table, Front front) {
  const Progress silent;
  GrowthTracer tracer(working, table, front, silent);
  return trace_connected(working, compute_nearest_labels(working, table), tracer, silent);
}

/// The vertices with these ids as generators.
inline std::vector<SurfacePoint> at_vertices(const Mesh& mesh, const std::vector<int>& ids) {
  std::vector<SurfacePoint> points;
  for (const int id : ids) points.push_back(vertex_point(mesh, VertexId(id)));
  return points;
}

inline const char* name(Front front) { return front == Front::circle ? "circle" : "planar"; }

}  // namespace gvd::test
