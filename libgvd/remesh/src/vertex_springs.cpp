// The springs of a fit: they pull vertices towards better triangles where the samples of the surface leave them free.
//
// Along a smooth surface a vertex goes to where its triangles are nearly equilateral: the mean of the apexes of
// equilateral triangles over the opposite edges, in which bad triangles weigh more. Across the surface, at creases
// and beside them the samples decide, and springs only keep the system regular. Weights are fractions of a cell's area,
// so that they compare with the samples of the cell, whatever its size.

#include <algorithm>
#include <cmath>

#include "placement_steps.hpp"

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

/// Weight of the springs along the surface, as a fraction of a cell's area. They pull towards better triangles, and
/// matter where the distances hardly change. In such a direction the samples weigh r^2 / 4 of the area, for a cell with
/// an angular radius of r. So springs outweigh the samples of cells below three quarters of a radian.
/// docs/notes/remesh-placement.md compares it with .2 and .3, and with .02 beside creases.
constexpr double kSmoothSpring = 0.15;

/// Weight of the springs along a crease.
constexpr double kAlongCreaseSpring = 0.03;

/// Weight across creases and beside them, where the samples decide: triangles miss the crease unless vertices move.
constexpr double kCreaseSpring = 0.001;

/// Weight across the surface, where the samples alone decide, too; it keeps the system regular.
constexpr double kNormalSpring = 0.001;

/// Weight of the spring of a vertex that stays: a million times the samples of its cell, and far from the limits of the
/// factorisation.
constexpr double kRigidSpring = 1e6;

using Matrix = Eigen::Matrix3d;

/// The projection to the direction of a unit vector, or to nothing.
Matrix onto(const Vec3& direction) { return direction * direction.transpose(); }

}  // namespace

std::vector<VertexShape> find_vertex_shapes(const Mesh& mesh) {
  std::vector<ShapeSum> sums(mesh.positions().size());
  for (const FaceId f : mesh.faces()) add_face(mesh.vertices(f), mesh, sums);
  std::vector<VertexShape> shapes;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const ShapeSum& sum = sums[v];
    const Vec3& here = mesh.positions()[v];
    shapes.push_back({sum.weight > 0 ? Vec3(sum.apexes / sum.weight) : here, sum.normal.normalized()});
  }
  return shapes;
}

std::vector<VertexRole> find_vertex_roles(const Mesh& remesh, const IdVector<GeneratorId, CreaseCell>& creases,
                                          const std::vector<char>& held) {
  std::vector<VertexRole> roles(held.size(), VertexRole::free);
  const auto is_creased = [&](VertexId v) { return creases[GeneratorId(v.value())].is_creased; };
  for (const EdgeId e : remesh.edges()) {
    const HalfedgeId h = remesh.halfedge(e);
    if (is_creased(remesh.from(h))) roles[remesh.to(h).index()] = VertexRole::near_crease;
    if (is_creased(remesh.to(h))) roles[remesh.from(h).index()] = VertexRole::near_crease;
  }
  for (const VertexId v : remesh.vertices()) {
    if (is_creased(v)) roles[v.index()] = VertexRole::at_crease;
    if (held[v.index()]) roles[v.index()] = VertexRole::held;
  }
  return roles;
}

std::vector<VertexAnchor> make_springs(const Mesh& current, const SpringPlan& plan) {
  const std::vector<VertexShape> shapes = find_vertex_shapes(current);
  const Matrix identity = Matrix::Identity();
  std::vector<VertexAnchor> springs;
  for (std::size_t v = 0; v < shapes.size(); ++v) {
    const Vec3& here = current.positions()[v];
    const Vec3 better = shapes[v].position - here, back = plan.remesh->positions()[v] - here;
    const Matrix across = onto(shapes[v].normal), tangent = identity - across;
    const Vec3& direction = plan.creases[GeneratorId(v)].direction;
    const Matrix along = onto(direction), beside = identity - along;
    const auto add = [&](const Vec3& way, const Matrix& weight) {
      springs.push_back({here + way, plan.areas[v] * weight});
    };
    switch (plan.roles[v]) {
      case VertexRole::free:
        add(tangent * better, kSmoothSpring * tangent + kNormalSpring * across);
        break;
      case VertexRole::near_crease:
        add(tangent * better, kCreaseSpring * tangent + kNormalSpring * across);
        break;
      case VertexRole::at_crease:
        add(along * better + beside * tangent * back,
            kAlongCreaseSpring * along + kCreaseSpring * beside * tangent * beside + kNormalSpring * identity);
        break;
      case VertexRole::held:
        add(Vec3(0, 0, 0), kRigidSpring * identity);
        break;
    }
  }
  return springs;
}

}  // namespace gvd
