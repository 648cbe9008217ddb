#include "io/writers/bisector_lines.hpp"

#include <limits>

namespace gvd::io {
std::vector<BisectorLine> collect_bisector_lines(const LabelledMesh& mesh) {
  std::vector<BisectorLine> lines;
  if (mesh.diagram == nullptr) return lines;
  const IdVector<VertexId, double>& distance = mesh.diagram->vertex_distance;
  const Mesh& surface = mesh.diagram_mesh != nullptr ? *mesh.diagram_mesh : mesh.mesh;
  for (const Bisector& bisector : mesh.diagram->bisectors) {
    if (bisector.points.size() < 2) continue;
    BisectorLine& line = lines.emplace_back();
    line.left = bisector.left;
    line.right = bisector.right;
    const auto add = [&](const SurfacePoint& point) {
      line.points.push_back(position(surface, point));
      line.distance.push_back(distance.empty() ? std::numeric_limits<double>::infinity()
                                               : interpolate_at(surface, distance, point));
    };
    for (const SurfacePoint& point : bisector.points) add(point);
    if (bisector.closed) add(bisector.points.front());
  }
  return lines;
}

}  // namespace gvd::io
