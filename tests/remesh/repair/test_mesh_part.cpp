// Parts of meshes: the faces of some cells.
#include <algorithm>

#include "repair/mesh_part.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_mesh_part {

TEST_CASE("rings of cells grow by one bisector a ring") {
  const Mesh mesh = test::make_torus(72, 36);
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 60, 2));
  const auto count = [](const CellFlags& flags) { return std::count(flags.begin(), flags.end(), 1); };
  const GeneratorId g(5);
  CHECK(count(grow_rings(diagram, {g}, 0)) == 1);
  CHECK(count(grow_rings(diagram, {g}, 1)) == 1 + std::ssize(diagram.cells[g].neighbours));
  CHECK(count(grow_rings(diagram, {g}, 60)) == 60);
}

TEST_CASE("mesh part: the faces of some cells, and points there and back") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 20, 4));
    const CellFlags cells = grow_rings(diagram, {GeneratorId(3)}, 1);
    const MeshPart part(mesh, diagram, cells);
    CHECK(part.mesh().face_count() == static_cast<std::int32_t>(part.size()));
    CHECK(part.mesh().face_count() < mesh.face_count());
    for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
      if (!cells[GeneratorId(i)]) continue;
      const auto point = part.to_part(diagram.generators[i]);
      REQUIRE(point);
      CHECK(part.to_whole(*point) == diagram.generators[i]);
      CHECK((position(part.mesh(), *point) - position(mesh, diagram.generators[i])).norm() == 0);
    }
  }
}

TEST_CASE("mesh part: all cells give the whole mesh, without a fringe") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 12, 1));
    const MeshPart part(mesh, diagram, CellFlags(diagram.cells.size(), 1));
    const MeshSummary whole = compute_mesh_summary(mesh), same = compute_mesh_summary(part.mesh());
    CHECK(same.faces == whole.faces);
    CHECK(same.vertices == whole.vertices);
    CHECK(same.boundary_loops == whole.boundary_loops);
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) CHECK_FALSE(part.is_fringe(FaceId(f)));
  }
}

TEST_CASE("mesh part: faces that meet at one vertex only get a vertex each") {
  // Two cells at opposite corners of a grid of four squares, whose faces meet in the middle.
  const Mesh mesh = test::make_grid(2, 2);
  std::vector<SurfacePoint> generators;
  for (const int v : {0, 2, 6, 8}) generators.push_back(vertex_point(mesh, VertexId(v)));
  Diagram diagram = compute_diagram(mesh, generators);
  // Whole faces only: each belongs to the corner that it is nearest to.
  diagram.pieces.clear();
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    diagram.face_label[FaceId(f)] = GeneratorId(f / 2);
  }
  CellFlags opposite(4, 0);
  opposite[GeneratorId(0)] = opposite[GeneratorId(3)] = 1;
  const MeshPart part(mesh, diagram, opposite);
  CHECK(part.mesh().face_count() == 4);
  CHECK(part.mesh().vertex_count() == 8);
  for (std::int32_t f = 0; f < 4; ++f) CHECK(part.is_fringe(FaceId(f)));
}

}  // namespace gvd::test_mesh_part
