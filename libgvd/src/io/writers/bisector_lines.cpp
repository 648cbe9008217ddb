#include "io/writers/bisector_lines.hpp"

#include <cstddef>
#include <limits>

namespace gvd::io {
namespace {

/// Linear in the face. A vertex with weight 0 is left out: its distance may be infinite.
double interpolate(const Mesh& mesh, const IdVector<VertexId, double>& values, const SurfacePoint& point) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.bary[i] > 0) sum += point.bary[i] * values[mesh.vertices(point.face)[i]];
  }
  return sum;
}

}  // namespace

std::vector<BisectorLine> collect_bisector_lines(const LabelledMesh& mesh) {
  std::vector<BisectorLine> lines;
  if (mesh.diagram == nullptr) return lines;
  const Mesh& surface = mesh.diagram_mesh != nullptr ? *mesh.diagram_mesh : mesh.mesh;
  for (const Bisector& bisector : mesh.diagram->bisectors) {
    if (bisector.points.size() < 2) continue;
    BisectorLine& line = lines.emplace_back();
    line.left = bisector.left;
    line.right = bisector.right;
    const auto add = [&](const SurfacePoint& point) {
      line.points.push_back(position(surface, point));
      line.distance.push_back(interpolate(surface, mesh.diagram->vertex_distance, point));
    };
    for (const SurfacePoint& point : bisector.points) add(point);
    if (bisector.closed) add(bisector.points.front());
  }
  return lines;
}

}  // namespace gvd::io
