// The parts of cells in faces: whole faces and pieces, of one face and of all.
#include <tuple>
#include <vector>

#include "diagram/cell_parts.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_cell_parts {

using Part = std::tuple<FaceId, GeneratorId, std::vector<Bary>>;

Part copy(const FacePart& part) { return {part.face, part.generator, {part.corners.begin(), part.corners.end()}}; }

std::vector<Part> parts_of(const Diagram& diagram, FaceId f) {
  std::vector<Part> parts;
  for_each_cell_part(diagram, f, [&](const FacePart& part) { parts.push_back(copy(part)); });
  return parts;
}

TEST_CASE("cell parts: a face in one cell is one part with its three corners") {
  const Mesh triangle = test::make_triangle();
  const Diagram diagram = compute_diagram(triangle, {vertex_point(triangle, VertexId(1))});
  CHECK(pieces_in(diagram, FaceId(0)).empty());
  const std::vector<Bary> corners(kWholeTriangle.begin(), kWholeTriangle.end());
  CHECK(parts_of(diagram, FaceId(0)) == std::vector<Part>{{FaceId(0), GeneratorId(0), corners}});
}

TEST_CASE("cell parts: a face that no generator reaches has none") {
  const Mesh mesh = test::make_two_components();
  const Diagram diagram = compute_diagram(mesh, {vertex_point(mesh, VertexId(0))});
  CHECK(parts_of(diagram, FaceId(0)).size() == 1);
  CHECK(parts_of(diagram, FaceId(mesh.face_count() - 1)).empty());
}

TEST_CASE("cell parts: a face that a bisector cuts has its pieces, in the diagram's order") {
  const Mesh triangle = test::make_triangle();
  const Diagram diagram =
      compute_diagram(triangle, {vertex_point(triangle, VertexId(0)), vertex_point(triangle, VertexId(1))});
  REQUIRE(diagram.pieces.size() == 2);
  CHECK(pieces_in(diagram, FaceId(0)).size() == 2);
  const std::vector<Part> parts = parts_of(diagram, FaceId(0));
  CHECK(parts == std::vector<Part>{copy(part_of(diagram.pieces[0])), copy(part_of(diagram.pieces[1]))});
}

TEST_CASE("cell parts: those of all faces are those of each, and have the area of the cells") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 12, 5));
    std::size_t count = 0, of_faces = 0;
    IdVector<GeneratorId, double> area(diagram.cells.size(), 0);
    for_each_cell_part(diagram, [&, &mesh = mesh](const FacePart& part) {
      ++count;
      area[part.generator] += area_share(part.corners) * mesh.area(part.face);
    });
    for (const FaceId f : mesh.faces()) of_faces += parts_of(diagram, f).size();
    CHECK(count == of_faces);
    for (const Cell& cell : diagram.cells) CHECK(area[cell.generator] == Approx(cell.area).epsilon(1e-9));
  }
}

}  // namespace gvd::test_cell_parts
