#include "placement/vertex_springs.hpp"

#include "placement/vertex_shapes.hpp"

namespace gvd {
namespace {

/// Weight of the springs along the surface, as a fraction of a cell's area. They pull towards better triangles, and
/// matter where the distances hardly change. In such a direction the samples weigh r^2 / 4 of the area, for a cell with
/// an angular radius of r. So springs outweigh the samples of cells below three quarters of a radian. Of other weights,
/// docs/notes/remesh-placement.md has what .2 and .3 gave here, and .02 beside creases.
constexpr double kSmoothSpring = 0.15;

/// The same along a crease.
constexpr double kAlongCreaseSpring = 0.03;

/// The same across creases and beside them, where the samples decide: triangles miss the crease unless vertices move.
constexpr double kCreaseSpring = 0.001;

/// Across the surface the samples alone decide, too; this keeps the system regular.
constexpr double kNormalSpring = 0.001;

/// Of a vertex that stays: a million times the samples of its cell, and far from the limits of the factorisation.
constexpr double kRigidSpring = 1e6;

using Matrix = Eigen::Matrix3d;

/// The projection to the direction of a unit vector, or to nothing.
Matrix onto(const Vec3& direction) { return direction * direction.transpose(); }

/// A spring that pulls from `here` by `way`, with weights for directions in multiples of `area`.
VertexAnchor pull(const Vec3& here, const Vec3& way, const Matrix& weight, double area) {
  return {here + way, area * weight};
}

}  // namespace

std::vector<VertexRole> find_vertex_roles(const Mesh& remesh, const IdVector<GeneratorId, CreaseCell>& creases,
                                          const std::vector<char>& held) {
  std::vector<VertexRole> roles(held.size(), VertexRole::free);
  const auto is_creased = [&](VertexId v) { return creases[GeneratorId(v.value())].is_creased; };
  for (std::int32_t e = 0; e < remesh.edge_count(); ++e) {
    const HalfedgeId h = remesh.halfedge(EdgeId(e));
    if (is_creased(remesh.from(h))) roles[remesh.to(h).index()] = VertexRole::near_crease;
    if (is_creased(remesh.to(h))) roles[remesh.from(h).index()] = VertexRole::near_crease;
  }
  for (std::int32_t v = 0; v < remesh.vertex_count(); ++v) {
    if (is_creased(VertexId(v))) roles[VertexId(v).index()] = VertexRole::at_crease;
    if (held[VertexId(v).index()]) roles[VertexId(v).index()] = VertexRole::held;
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
      springs.push_back(pull(here, way, weight, plan.areas[v]));
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
