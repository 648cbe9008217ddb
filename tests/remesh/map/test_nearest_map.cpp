// The nearest points of a remesh: every vertex, in its cell's triangles.
#include <algorithm>

#include "map/nearest_map.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_nearest_map {

/// Whether a triangle has the vertex or one of its neighbours as a corner.
bool is_near(const Mesh& mesh, FaceId f, VertexId vertex, const Cell& cell) {
  for (const VertexId v : mesh.vertices(f)) {
    const GeneratorId g(v.value());
    if (v == vertex || std::binary_search(cell.neighbours.begin(), cell.neighbours.end(), g)) return true;
  }
  return false;
}

TEST_CASE("nearest points: each is in a triangle of the vertex's cell or of a neighbour") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {5, 40}) {
      INFO(name << ", " << count << " generators");
      const RemeshResult result = remesh(mesh, test::random_generators(mesh, count, 1));
      const auto points = nearest_points(mesh, result, 0);
      REQUIRE(points.size() == static_cast<std::size_t>(mesh.vertex_count()));
      for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
        const GeneratorId label = result.diagram.vertex_label[VertexId(i)];
        REQUIRE(is_near(result.mesh, points[VertexId(i)].face, VertexId(label.value()), result.diagram.cells[label]));
        REQUIRE((!mesh.is_boundary(VertexId(i)) || is_on_boundary(result.mesh, points[VertexId(i)])));
      }
    }
  }
}

}  // namespace gvd::test_nearest_map
