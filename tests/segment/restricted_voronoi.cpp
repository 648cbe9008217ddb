#include "segment/restricted_voronoi.hpp"

#include <limits>

namespace gvd::test {
namespace {

using Polygon = std::vector<std::array<double, 3>>;

/// The subset of a polygon of barycentric coordinates where a linear function, given at the corners of the face, is <=
/// 0.
Polygon clip(const Polygon& polygon, const std::array<double, 3>& value) {
  const auto at = [&](const std::array<double, 3>& b) { return b[0] * value[0] + b[1] * value[1] + b[2] * value[2]; };
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double u = at(p), v = at(q);
    if (u <= 0) kept.push_back(p);
    if ((u < 0 && v > 0) || (u > 0 && v < 0)) {
      const double t = u / (u - v);
      kept.push_back({(1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1], (1 - t) * p[2] + t * q[2]});
    }
  }
  return kept;
}

double twice_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    sum += p[1] * q[2] - p[2] * q[1];
  }
  return sum;
}

std::vector<FacePiece> cut(const Mesh& mesh, FaceId f, const std::vector<Vec3>& positions) {
  std::vector<FacePiece> pieces;
  for (std::size_t g = 0; g < positions.size(); ++g) {
    Polygon polygon{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t other = 0; other < positions.size() && polygon.size() >= 3; ++other) {
      if (other == g) continue;
      std::array<double, 3> value{};
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& p = mesh.position(mesh.vertices(f)[i]);
        value[i] = (p - positions[g]).squaredNorm() - (p - positions[other]).squaredNorm();
      }
      polygon = clip(polygon, value);
    }
    if (polygon.size() >= 3 && twice_area(polygon) > 1e-14) {
      pieces.push_back({f, GeneratorId(g), polygon});
    }
  }
  return pieces;
}

}  // namespace

Diagram make_restricted_voronoi(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  Diagram diagram;
  diagram.generators = generators;
  std::vector<Vec3> positions;
  for (const SurfacePoint& point : generators) positions.push_back(position(mesh, point));
  for (const Vec3& p : mesh.positions()) {
    std::size_t best = 0;
    for (std::size_t g = 1; g < positions.size(); ++g) {
      if ((p - positions[g]).norm() < (p - positions[best]).norm()) best = g;
    }
    diagram.vertex_label.push_back(GeneratorId(best));
    diagram.vertex_distance.push_back((p - positions[best]).norm());
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::vector<FacePiece> pieces = cut(mesh, FaceId(f), positions);
    diagram.face_label.push_back(pieces.size() == 1 ? pieces[0].generator : GeneratorId());
    if (pieces.size() > 1) diagram.pieces.insert(diagram.pieces.end(), pieces.begin(), pieces.end());
  }
  return diagram;
}

}  // namespace gvd::test
