#include "diagram/envelope/separate_arcs.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"

namespace gvd::test_separate_arcs {

/// A face with crossings at these boundary positions, and arcs between them through inner points in affine coordinates.
struct HandMadeFace {
  FaceDiagram diagram;
  std::vector<BoundaryCrossing> boundary;
  OpenFace face{diagram, boundary};
  ArcSeparator separator;

  explicit HandMadeFace(const std::vector<std::pair<double, int>>& crossings)
      : boundary(test::boundary_of(crossings)) {}

  void add_arc(int from, int to, const std::vector<Vec2>& inner) {
    const BoundaryCrossing &first = boundary[std::size_t(from)], &last = boundary[std::size_t(to)];
    FaceArc arc{FaceId(0), at(first.id), at(last.id), first.previous, first.next};
    arc.first_point = static_cast<std::int32_t>(diagram.points.size());
    arc.point_count = static_cast<std::int32_t>(inner.size());
    for (const Vec2& p : inner) diagram.points.push_back({1 - p.x() - p.y(), p.x(), p.y()});
    diagram.arcs.push_back(arc);
  }
};

TEST_CASE("a face without arcs, with one straight arc or one that advances is left as it is") {
  HandMadeFace empty({{0.5, 1}, {1.5, 0}});
  CHECK_FALSE(empty.separator.separate(empty.face));
  empty.add_arc(0, 1, {});
  CHECK_FALSE(empty.separator.separate(empty.face));
  HandMadeFace bent({{0.5, 1}, {1.5, 0}});
  bent.add_arc(0, 1, {{0.55, 0.2}, {0.5, 0.4}});
  CHECK_FALSE(bent.separator.separate(bent.face));
  CHECK(bent.diagram.arcs[0].point_count == 2);
}

TEST_CASE("an arc that turns back without an intersection keeps its points") {
  HandMadeFace face({{0.5, 1}, {1.5, 0}});
  face.add_arc(0, 1, {{0.5, 0.3}, {0.4, 0.2}, {0.4, 0.45}});
  CHECK_FALSE(face.separator.separate(face.face));
  CHECK(face.diagram.arcs[0].point_count == 3);
}

TEST_CASE("an arc that intersects itself loses its loop") {
  HandMadeFace face({{0.5, 1}, {1.5, 0}});
  face.add_arc(0, 1, {{0.4, 0.3}, {0.3, 0.3}, {0.3, 0.2}, {0.6, 0.2}});
  CHECK(face.separator.separate(face.face));
  CHECK(face.diagram.arcs[0].point_count < 4);
  CHECK(face.diagram.arcs[0].point_count > 0);
  CHECK_FALSE(face.separator.separate(face.face));
}

TEST_CASE("of two arcs that intersect, the one with inner points becomes straight") {
  // From side 0 to side 1 and from side 0 to side 2; the second one bends across the first.
  HandMadeFace face({{0.3, 0}, {0.7, 1}, {1.5, 0}, {2.5, 2}});
  face.add_arc(1, 2, {});
  face.add_arc(0, 3, {{0.72, 0.2}});
  CHECK(face.separator.separate(face.face));
  CHECK(face.diagram.arcs[0].point_count == 0);
  CHECK(face.diagram.arcs[1].point_count == 0);
  CHECK_FALSE(face.separator.separate(face.face));
}

TEST_CASE("the arc with the most intersections is changed first, and the others keep their points") {
  HandMadeFace face({{0.2, 0}, {0.5, 1}, {0.8, 2}, {1.2, 1}, {1.5, 0}, {2.5, 3}});
  face.add_arc(2, 3, {{0.76, 0.12}});
  face.add_arc(1, 4, {{0.5, 0.25}});
  face.add_arc(0, 5, {{0.9, 0.05}});  // across both
  CHECK(face.separator.separate(face.face));
  CHECK(face.diagram.arcs[0].point_count == 1);
  CHECK(face.diagram.arcs[1].point_count == 1);
  CHECK(face.diagram.arcs[2].point_count == 0);
}

TEST_CASE("straight arcs that intersect make a face inverted, arcs that only touch do not") {
  HandMadeFace crossed({{0.3, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  crossed.add_arc(0, 2, {});
  crossed.add_arc(1, 3, {});
  CHECK(crossed.separator.is_inverted(crossed.face));
  HandMadeFace apart({{0.3, 0}, {0.7, 1}, {1.5, 0}, {2.5, 1}});
  apart.add_arc(0, 3, {});
  apart.add_arc(1, 2, {});
  CHECK_FALSE(apart.separator.is_inverted(apart.face));
}

TEST_CASE("only the face at the end of a diagram is looked at, and cleared") {
  FaceDiagram diagram;
  const std::vector<BoundaryCrossing> boundary = test::boundary_of({{0.5, 1}, {1.5, 0}});
  diagram.arcs.push_back({FaceId(0), at(CrossingId(7)), at(CrossingId(8)), GeneratorId(0), GeneratorId(1)});
  diagram.branches.push_back({FaceId(0), {0.3, 0.3, 0.4}});
  OpenFace face(diagram, boundary);
  CHECK(face.arcs().empty());
  CHECK(face.first_branch() == face.end_branch());
  diagram.arcs.push_back({FaceId(1), at(CrossingId(0)), at(CrossingId(1)), GeneratorId(0), GeneratorId(1)});
  const BranchPointId b = diagram.branches.push_back({FaceId(1), {0.2, 0.2, 0.6}});
  CHECK(face.arcs().size() == 1);
  CHECK(face.first_branch() == b);
  CHECK(face.position(at(b)) == Bary{0.2, 0.2, 0.6});
  CHECK(face.position(at(CrossingId(1))) == Bary{0, 0.5, 0.5});
  face.clear();
  CHECK(diagram.arcs.size() == 1);
  CHECK(diagram.branches.size() == 1);
}

}  // namespace gvd::test_separate_arcs
