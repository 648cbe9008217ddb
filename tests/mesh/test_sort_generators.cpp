#include "gvd/error.hpp"
#include "mesh/sort_generators.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_sort_generators {

TEST_CASE("generators are sorted by what they lie on, and along each edge") {
  const Mesh mesh = test::make_grid(1, 1);
  HalfedgeId diagonal;
  for (int i = mesh.halfedge_count(); i-- > 0;) {
    if (mesh.twin(HalfedgeId(i)).valid()) diagonal = HalfedgeId(i);
  }
  const SortedGenerators sorted =
      sort_generators(mesh, {edge_point(diagonal, 0.75), vertex_point(mesh, VertexId(2)),
                             edge_point(mesh.twin(diagonal), 0.5), make_surface_point(FaceId(1), {0.2, 0.3, 0.5}),
                             make_surface_point(FaceId(1), {0.5, 0.3, 0.2}), edge_point(diagonal, 0.25)});
  REQUIRE(sorted.on_vertices.size() == 1);
  CHECK(sorted.on_vertices[0] == std::pair(VertexId(2), GeneratorId(1)));
  REQUIRE(sorted.on_edges.size() == 3);
  const int order[] = {5, 2, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(sorted.on_edges[i].halfedge == diagonal);
    CHECK(sorted.on_edges[i].t == 0.25 * double(i + 1));
    CHECK(sorted.on_edges[i].generator == GeneratorId(order[i]));
  }
  REQUIRE(sorted.in_faces.size() == 1);
  CHECK(sorted.in_faces.at(FaceId(1)) == std::vector<GeneratorId>{GeneratorId(3), GeneratorId(4)});
}

TEST_CASE("every generator of a family is sorted once, on the halfedge that comes first") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const std::vector<SurfacePoint> generators = test::random_generators(mesh, 90, 3);
    const SortedGenerators sorted = sort_generators(mesh, generators);
    std::size_t count = sorted.on_vertices.size() + sorted.on_edges.size();
    for (const auto& [face, ids] : sorted.in_faces) count += ids.size();
    REQUIRE(count == generators.size());
    for (const EdgeGenerator& on : sorted.on_edges) {
      REQUIRE((!mesh.twin(on.halfedge).valid() || on.halfedge < mesh.twin(on.halfedge)));
      const Vec3 expected = position(mesh, generators[on.generator.index()]);
      REQUIRE((position(mesh, edge_point(on.halfedge, on.t)) - expected).norm() < 1e-14 * mesh.bbox_diagonal());
    }
  }
}

TEST_CASE("no generator, and one in a face that does not exist, are refused") {
  const Mesh mesh = test::make_triangle();
  CHECK_THROWS_AS(sort_generators(mesh, {}), Error);
  CHECK_THROWS_AS(sort_generators(mesh, {{FaceId(1), {1, 0, 0}}}), Error);
  CHECK_THROWS_AS(sort_generators(mesh, {{FaceId(), {1, 0, 0}}}), Error);
}

}  // namespace gvd::test_sort_generators
