// Positions of better triangles.
#include <cmath>

#include "gvd/quality.hpp"
#include "placement/vertex_shapes.hpp"
#include "placement/with_positions.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_vertex_shapes {

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

}  // namespace gvd::test_vertex_shapes
