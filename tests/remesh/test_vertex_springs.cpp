// Positions of better triangles, and the springs towards them.
#include <cmath>

#include "cell_quadrics.hpp"
#include "fit_vertices.hpp"
#include "gvd/quality.hpp"
#include "move_guard.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_vertex_springs {

TEST_CASE("vertices of equilateral triangles stay, with the normal of their faces") {
  const Mesh triangle({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3.0) / 2, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const auto shapes = find_vertex_shapes(triangle);
  for (std::size_t v = 0; v < 3; ++v) {
    CHECK((shapes[v].position - triangle.positions()[v]).norm() < 1e-14);
    CHECK((shapes[v].normal - Vec3(0, 0, 1)).norm() < 1e-14);
  }
}

TEST_CASE("the apex of a flat triangle rises above its base") {
  const Mesh flat({{0, 0, 0}, {2, 0, 0}, {1, 0.1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  CHECK((find_vertex_shapes(flat)[2].position - Vec3(1, std::sqrt(3.0), 0)).norm() < 1e-14);
}

TEST_CASE("half a step to there makes triangles better") {
  const Mesh sphere = test::make_bumpy_sphere(3, 1);
  std::vector<Vec3> positions = sphere.positions();
  const auto shapes = find_vertex_shapes(sphere);
  for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += (shapes[v].position - positions[v]) / 2;
  const Mesh better = with_positions(sphere, positions);
  CHECK(compute_triangle_quality(better).q_average > compute_triangle_quality(sphere).q_average);
}

/// A grid in the plane z = 0 with one creased vertex in its middle, and its corner held.
SpringPlan make_plan(const Mesh& grid, VertexId middle) {
  SpringPlan plan{&grid, IdVector<GeneratorId, CreaseCell>(grid.positions().size()), {}, {}};
  plan.creases[GeneratorId(middle.value())] = {true, Vec3(1, 0, 0), false};
  std::vector<char> held(grid.positions().size(), 0);
  held[0] = 1;
  plan.roles = find_vertex_roles(grid, plan.creases, held);
  plan.areas.assign(grid.positions().size(), 2.0);
  return plan;
}

TEST_CASE("vertices at creases, their neighbours and held ones have their own springs") {
  const Mesh grid = test::make_grid(4, 4);
  const VertexId middle(12);
  const SpringPlan plan = make_plan(grid, middle);
  CHECK(plan.roles[0] == VertexRole::held);
  CHECK(plan.roles[middle.index()] == VertexRole::at_crease);
  CHECK(plan.roles[middle.index() + 1] == VertexRole::near_crease);
  CHECK(plan.roles.back() == VertexRole::free);
  const std::vector<VertexAnchor> springs = make_springs(grid, plan);
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const auto stiffness = [&](std::size_t v, const Vec3& d) { return d.dot(springs[v].weight * d) / 2.0; };
  CHECK(stiffness(0, x) > 1e5);
  CHECK(springs[0].position == grid.positions()[0]);
  CHECK(stiffness(middle.index(), x) > 5 * stiffness(middle.index(), y));
  CHECK(stiffness(grid.positions().size() - 1, x) > 50 * stiffness(middle.index() + 1, x));
  for (std::size_t v = 1; v < springs.size(); ++v) {
    CHECK(stiffness(v, z) > 0);
    CHECK(stiffness(v, z) < 0.01);
  }
}

}  // namespace gvd::test_vertex_springs
