#include <cmath>

#include "gvd/error.hpp"
#include "gvd/segment.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_cut_faces {

TEST_CASE("the vertices of a cut mesh keep labels and distances, and new ones lie between them") {
  const Mesh mesh = test::make_grid(4, 3);
  const Diagram diagram = compute_diagram(mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(19)),
                                                 make_surface_point(FaceId(10), {0.2, 0.3, 0.5})});
  const CutMesh cut = cut_faces(mesh, diagram);
  const CutVertices carried = carry_to_cut_vertices(mesh, diagram, cut);
  REQUIRE(carried.label.size() == cut.mesh.positions().size());
  REQUIRE(carried.distance.size() == cut.mesh.positions().size());
  REQUIRE(cut.mesh.vertex_count() > mesh.vertex_count());
  for (int i = 0; i < cut.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    if (i < mesh.vertex_count()) {
      CHECK(carried.label[v] == diagram.vertex_label[v]);
      CHECK(carried.distance[v] == diagram.vertex_distance[v]);
      continue;
    }
    // The mesh is flat: the distance is known. Linear between vertices it is off by less than an edge.
    const Vec3 generator = position(mesh, diagram.generators[carried.label[v].index()]);
    CHECK(std::abs(carried.distance[v] - (generator - cut.mesh.position(v)).norm()) < 0.75);
    GeneratorId smallest;
    for (int f = 0; f < cut.mesh.face_count(); ++f) {
      for (const VertexId corner : cut.mesh.vertices(FaceId(f))) {
        const GeneratorId label = cut.label[FaceId(f)];
        if (corner == v && (!smallest.valid() || label < smallest)) smallest = label;
      }
    }
    CHECK(carried.label[v] == smallest);
  }
}

TEST_CASE("a cut vertex in the middle of an edge has the mean distance of its ends") {
  const Mesh mesh({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}},
                  {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(3), VertexId(2), VertexId(1)}});
  const Diagram diagram = compute_diagram(mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))});
  const CutMesh cut = cut_faces(mesh, diagram);
  const CutVertices carried = carry_to_cut_vertices(mesh, diagram, cut);
  int found = 0;
  for (int i = 4; i < cut.mesh.vertex_count(); ++i) {
    if (cut.mesh.position(VertexId(i)).isApprox(Vec3(1, 2, 0))) {
      CHECK(carried.distance[VertexId(i)] == Approx(2));  // both ends of the edge are 2 from a generator
      ++found;
    }
  }
  CHECK(found == 1);
}

TEST_CASE("what no generator reaches stays without label and distance in a cut mesh") {
  const Mesh mesh = test::make_two_components();
  const Diagram diagram = compute_diagram(mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))});
  const CutVertices carried = carry_to_cut_vertices(mesh, diagram, cut_faces(mesh, diagram));
  int unreached = 0;
  for (std::size_t i = 0; i < carried.label.size(); ++i) {
    CHECK(carried.label.raw()[i].valid() == std::isfinite(carried.distance.raw()[i]));
    unreached += !carried.label.raw()[i].valid();
  }
  CHECK(unreached > 0);
  CHECK_THROWS_AS(carry_to_cut_vertices(test::make_grid(1, 1), diagram, cut_faces(mesh, diagram)), Error);
}

}  // namespace gvd::test_cut_faces
