#include "placement/vertex_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gvd {
namespace {

/// Bounds the weight of triangles with hardly any area.
constexpr double kLeastQuality = 0.05;

/// Sums over the faces of a vertex.
struct ShapeSum {
  Vec3 apexes = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  double weight = 0;
};

void add_face(const std::array<VertexId, 3>& vertices, const Mesh& mesh, std::vector<ShapeSum>& sums) {
  const std::array<Vec3, 3> at{mesh.position(vertices[0]), mesh.position(vertices[1]), mesh.position(vertices[2])};
  const Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]);
  const double squares = (at[1] - at[0]).squaredNorm() + (at[2] - at[1]).squaredNorm() + (at[0] - at[2]).squaredNorm();
  const double quality = 2 * std::sqrt(3.0) * normal.norm() / squares;
  const double weight = 1 / std::max(kLeastQuality, quality);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = at[(k + 1) % 3], &b = at[(k + 2) % 3];
    const Vec3 height = std::sqrt(3.0) / 2 * normal.normalized().cross(b - a);
    ShapeSum& sum = sums[vertices[k].index()];
    sum.apexes += weight * ((a + b) / 2 + height);
    sum.normal += normal;
    sum.weight += weight;
  }
}

}  // namespace

std::vector<VertexShape> find_vertex_shapes(const Mesh& mesh) {
  std::vector<ShapeSum> sums(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) add_face(mesh.vertices(FaceId(f)), mesh, sums);
  std::vector<VertexShape> shapes;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const ShapeSum& sum = sums[v];
    const Vec3& here = mesh.positions()[v];
    shapes.push_back({sum.weight > 0 ? Vec3(sum.apexes / sum.weight) : here, sum.normal.normalized()});
  }
  return shapes;
}

}  // namespace gvd
