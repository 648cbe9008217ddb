#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "judge.hpp"

// What the tests of all comparators ask.

namespace gvd::test {

inline double total_area(const Diagram& diagram) {
  double sum = 0;
  for (const Cell& cell : diagram.cells) sum += cell.area;
  return sum;
}

inline double mesh_area(const Mesh& mesh) { return compute_mesh_summary(mesh).area; }

inline double error_of(const paper::Judge& judge, const Diagram& diagram) {
  return judge.judge(diagram).error.error_integral;
}

/// Vertices `first`, `first + step` and so on.
inline std::vector<SurfacePoint> vertex_points(const Mesh& mesh, int count, int first, int step) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(vertex_point(mesh, VertexId(first + step * i)));
  return points;
}

}  // namespace gvd::test
