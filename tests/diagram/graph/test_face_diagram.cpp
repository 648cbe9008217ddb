#include <vector>

#include "base/barycentric.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "support/catch.hpp"

namespace gvd::test_face_diagram {

/// One face with an arc from a crossing to a branch point, by way of two inner points.
FaceDiagram one_face(int face, int crossing, double x) {
  FaceDiagram diagram;
  diagram.branches.push_back({FaceId(face), {x, 0.5, 0.5 - x}, 1});
  diagram.points = {{x, 0, 1 - x}, {0, x, 1 - x}};
  FaceArc arc{FaceId(face), at(CrossingId(crossing)), at(BranchPointId(0)), GeneratorId(0), GeneratorId(1)};
  arc.first_point = 0;
  arc.point_count = 2;
  diagram.arcs.push_back(arc);
  return diagram;
}

std::vector<Bary> inner(const FaceDiagram& diagram, std::size_t arc) {
  const auto points = diagram.inner_points(diagram.arcs[arc]);
  return {points.begin(), points.end()};
}

TEST_CASE("an arc's end is a crossing or a branch point") {
  CHECK(at(CrossingId(3)) == at(CrossingId(3)));
  CHECK_FALSE(at(CrossingId(3)) == at(CrossingId(4)));
  CHECK_FALSE(at(CrossingId(3)) == at(BranchPointId(3)));
  CHECK(at(CrossingId(3)).crossing.valid());
  CHECK_FALSE(at(CrossingId(3)).branch.valid());
}

TEST_CASE("a straight arc has no inner points") {
  FaceDiagram diagram;
  diagram.arcs.push_back({FaceId(0), at(CrossingId(0)), at(CrossingId(1)), GeneratorId(0), GeneratorId(1)});
  CHECK(inner(diagram, 0).empty());
}

TEST_CASE("appending an empty diagram, or to one, changes nothing") {
  FaceDiagram diagram = one_face(2, 5, 0.25), empty;
  diagram.append(FaceDiagram());
  empty.append(diagram);
  for (const FaceDiagram* d : {&diagram, &empty}) {
    REQUIRE(d->arcs.size() == 1);
    CHECK(d->arcs[0].end == at(BranchPointId(0)));
    CHECK(inner(*d, 0) == std::vector<Bary>{{0.25, 0, 0.75}, {0, 0.25, 0.75}});
  }
}

TEST_CASE("appended arcs keep their crossings, branch points and inner points") {
  FaceDiagram diagram = one_face(2, 5, 0.25);
  diagram.append(one_face(3, 7, 0.125));
  REQUIRE(diagram.arcs.size() == 2);
  CHECK(diagram.arcs[1].face == FaceId(3));
  CHECK(diagram.arcs[1].begin == at(CrossingId(7)));  // crossings are numbered for all faces
  CHECK(diagram.arcs[1].end == at(BranchPointId(1)));
  CHECK(diagram.branches[diagram.arcs[1].end.branch].face == FaceId(3));
  CHECK(inner(diagram, 0) == std::vector<Bary>{{0.25, 0, 0.75}, {0, 0.25, 0.75}});
  CHECK(inner(diagram, 1) == std::vector<Bary>{{0.125, 0, 0.875}, {0, 0.125, 0.875}});
}

}  // namespace gvd::test_face_diagram
