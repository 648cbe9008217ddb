#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagram/evaluation/check_partition.hpp"
#include "support/catch.hpp"
#include "support/three_cells.hpp"

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

}  // namespace gvd::test_check_partition
