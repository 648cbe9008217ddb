#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagram/check_parts.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/three_cells.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_check_partition {

using test::ThreeCells;

using Lines = std::vector<std::string>;

Lines find(const ThreeCells& x) { return x.run(check_partition, ReachedFaces(x.mesh, x.diagram.generators)); }

TEST_CASE("the cells of a sound diagram are a partition") { CHECK(find(ThreeCells()).empty()); }

TEST_CASE("a cell's area, a vertex's label and a piece that is missing") {
  ThreeCells area;
  area.cell(1).area *= 1.01;
  CHECK(find(area) == Lines{"(2) cell 1: its area is not that of its faces and pieces"});
  ThreeCells label;
  label.diagram.vertex_label[VertexId(0)] = GeneratorId(2);
  for (const std::string& line : find(label)) {
    CHECK(line == "(2) vertex 0: its label is not that of a face or piece at it");
  }
  CHECK_FALSE(find(label).empty());
  ThreeCells missing;
  const std::string face = std::to_string(missing.diagram.pieces[0].face.value());
  missing.diagram.pieces.erase(missing.diagram.pieces.begin());
  const Lines lines = find(missing);
  REQUIRE(lines.size() == 2);  // the face, and the cell whose piece it was
  CHECK(lines[0].starts_with("(2) face " + face + ": its label and pieces cover 0."));
  CHECK(lines[0].ends_with(" of its area instead of 1"));
}

TEST_CASE("without a generator no face is reached") {
  const Mesh mesh = test::make_triangle();
  CHECK_FALSE(ReachedFaces(mesh, {}).contains(FaceId(0)));
}

TEST_CASE("one generator reaches its component, and no other") {
  const Mesh mesh = test::make_two_components();
  const FaceId last(mesh.face_count() - 1);
  const ReachedFaces first_only(mesh, {vertex_point(mesh, VertexId(0))});
  CHECK(first_only.contains(FaceId(0)));
  CHECK_FALSE(first_only.contains(last));
  const ReachedFaces last_only(mesh, {make_surface_point(last, {0.3, 0.3, 0.4})});
  CHECK_FALSE(last_only.contains(FaceId(0)));
  CHECK(last_only.contains(last));
  const ReachedFaces both(mesh, {vertex_point(mesh, VertexId(0)), make_surface_point(last, {0.3, 0.3, 0.4})});
  for (int f = 0; f < mesh.face_count(); ++f) REQUIRE(both.contains(FaceId(f)));
}

}  // namespace gvd::test_check_partition
