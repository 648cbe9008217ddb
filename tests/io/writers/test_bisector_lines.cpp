#include <cmath>

#include "io/fixture.hpp"
#include "io/writers/bisector_lines.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_bisector_lines {

using namespace test;

TEST_CASE("a line has the points of its bisector, and a closed one repeats the first") {
  const Labelled labelled;
  const auto lines = io::collect_bisector_lines(labelled.view());
  REQUIRE(lines.size() == labelled.diagram.bisectors.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Bisector& bisector = labelled.diagram.bisectors[BisectorId(std::int64_t(i))];
    CHECK(lines[i].left == bisector.left);
    CHECK(lines[i].right == bisector.right);
    REQUIRE(lines[i].points.size() == bisector.points.size() + bisector.closed);
    REQUIRE(lines[i].distance.size() == lines[i].points.size());
    CHECK(lines[i].points.front() == position(labelled.mesh, bisector.points.front()));
    if (bisector.closed) CHECK(lines[i].points.back() == lines[i].points.front());
  }
}

TEST_CASE("the distance is linear in the face, and a vertex without weight has no influence") {
  const Mesh mesh = make_grid(1, 1);
  Diagram diagram;
  diagram.vertex_distance = IdVector<VertexId, double>(std::vector<double>(4, INFINITY));
  const auto& [a, b, c] = mesh.vertices(FaceId(0));
  diagram.vertex_distance[a] = 2;
  diagram.vertex_distance[b] = 6;
  Bisector bisector;
  bisector.points = {make_surface_point(FaceId(0), {0.75, 0.25, 0}), make_surface_point(FaceId(0), {0.5, 0.25, 0.25})};
  diagram.bisectors.push_back(bisector);
  LabelledMesh labelled{mesh};
  labelled.diagram = &diagram;
  const auto distance = io::collect_bisector_lines(labelled).at(0).distance;
  CHECK(distance[0] == 3);
  CHECK(distance[1] == INFINITY);
  diagram.vertex_distance = {};
  CHECK(io::collect_bisector_lines(labelled).at(0).distance[0] == INFINITY);
}

TEST_CASE("bisectors of one point are left out, and without a diagram there are no lines") {
  Labelled labelled;
  labelled.diagram.bisectors[BisectorId(1)].points.resize(1);
  CHECK(io::collect_bisector_lines(labelled.view()).size() == labelled.diagram.bisectors.size() - 1);
  CHECK(io::collect_bisector_lines({labelled.mesh}).empty());
}

}  // namespace gvd::test_bisector_lines
