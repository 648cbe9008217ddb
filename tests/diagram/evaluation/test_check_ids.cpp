#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagram/evaluation/check_ids.hpp"
#include "support/catch.hpp"
#include "support/three_cells.hpp"

namespace gvd::test_check_ids {

using test::ThreeCells;

using Lines = std::vector<std::string>;

Lines find(const ThreeCells& x) { return x.run(check_ids); }

TEST_CASE("ids of a sound diagram are valid") { CHECK(find(ThreeCells()).empty()); }

TEST_CASE("an end at a branch point that does not exist") {
  ThreeCells broken;
  Bisector* b = &broken.bisector(0);
  b->ends[0] = BranchPointId(7);
  CHECK(find(broken) == Lines{"(4) bisector 0: ends at a branch point that does not exist"});
}

TEST_CASE("sizes, labels and faces that do not match the mesh") {
  ThreeCells cells;
  cells.diagram.cells.raw().pop_back();
  CHECK(find(cells)[0] == "(1) cells are not numbered like the generators, or a generator lies in no face of the mesh");
  ThreeCells labels;
  labels.diagram.vertex_label[VertexId(3)] = GeneratorId(3);
  CHECK(find(labels) ==
        Lines{"(2) labels or pieces do not match the mesh in number, or name a cell or face that does not exist"});
  ThreeCells points;
  points.bisector(2).points[1].face = FaceId(points.mesh.face_count());
  CHECK(find(points) == Lines{"(3) bisector 2: names a cell or face that does not exist"});
}

TEST_CASE("a diagram without anything matches no mesh but the empty one") {
  ThreeCells empty;
  empty.diagram = Diagram();
  CHECK(find(empty).size() == 1);  // no labels
}

}  // namespace gvd::test_check_ids
