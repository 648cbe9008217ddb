#include <algorithm>
#include <cmath>

#include "base/barycentric.hpp"
#include "diagram/envelope/separate_arcs.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"
#include "support/random.hpp"

namespace gvd::test_separate_arcs {

using Pairs = std::vector<ArcIntersections::Pair>;

/// The segments of polylines, one arc each.
std::vector<ArcSegment> segments_of(const std::vector<std::vector<Vec2>>& arcs) {
  std::vector<ArcSegment> segments;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (std::size_t k = 1; k < arcs[i].size(); ++k)
      segments.push_back({{arcs[i][k - 1], arcs[i][k]}, static_cast<std::int32_t>(i)});
  }
  return segments;
}

Pairs intersections_of(const std::vector<std::vector<Vec2>>& arcs) {
  ArcIntersections intersections;
  return intersections.find(segments_of(arcs));
}

TEST_CASE("no arc, one segment and two consecutive segments have no intersection") {
  CHECK(intersections_of({}).empty());
  CHECK(intersections_of({{{0, 0}, {1, 1}}}).empty());
  CHECK(intersections_of({{{0, 0}, {1, 1}, {0.5, 0.2}}}).empty());
}

TEST_CASE("arcs that cross intersect, also one with itself, arcs with a common end do not") {
  CHECK(intersections_of({{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}}) == Pairs{{0, 1}});
  CHECK(intersections_of({{{0, 0}, {1, 1}}, {{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}}).empty());
  CHECK(intersections_of({{{0, 0}, {1, 0}, {1, 1}, {0.5, -1}}}) == Pairs{{0, 0}});
}

TEST_CASE("an arc that ends on another one, or overlaps it, intersects it") {
  CHECK(intersections_of({{{0, 0}, {1, 0}}, {{0.3, 0}, {0.5, 1}}}) == Pairs{{0, 1}});
  CHECK(intersections_of({{{0, 0}, {1, 0}}, {{0.3, 0}, {0.6, 0}}}) == Pairs{{0, 1}});
  CHECK(intersections_of({{{0, 0}, {1, 0}}, {{1.5, 0}, {2, 0}}}).empty());
}

TEST_CASE("an intersection that rounding leaves open is found, one beyond rounding is not") {
  const double third = 1.0 / 3;
  const auto touching = [&](double above) {
    return intersections_of({{{0, 0}, {1, third}}, {{0.3, 0.3 * third + above}, {0.2, 1}}});
  };
  CHECK(touching(1e-17) == Pairs{{0, 1}});
  CHECK(touching(1e-15).empty());
}

TEST_CASE("random arcs of many lengths and sizes: the result is that of all pairs of segments") {
  test::Random random(3);
  ArcIntersections intersections;
  for (int round = 0; round < 400; ++round) {
    std::vector<std::vector<Vec2>> arcs(static_cast<std::size_t>(1 + random.below(5)));
    for (auto& arc : arcs) {
      const double size = std::pow(10, random.real(-6, 0));
      Vec2 p(random.real(0, 1), random.real(0, 1));
      for (int k = random.below(30); k >= 0; --k, p += size * Vec2(random.real(-1, 1), random.real(-1, 1)))
        arc.push_back(p);
    }
    const auto segments = segments_of(arcs);
    Pairs expected;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (may_intersect(segments[i].line, segments[j].line))
          expected.push_back(std::minmax({segments[i].arc, segments[j].arc}));
      }
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    INFO("round " << round);
    REQUIRE(intersections.find(segments) == expected);
  }
}

using Polyline = std::vector<Bary>;

Bary at(double x, double y) { return {1 - x - y, x, y}; }

bool intersects_itself(const Polyline& polyline) {
  std::vector<ArcSegment> segments;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    segments.push_back({{affine_point(polyline[i - 1]), affine_point(polyline[i])}, 0});
  }
  ArcIntersections intersections;
  return !intersections.find(segments).empty();
}

TEST_CASE("a polyline without a loop does not change") {
  Polyline polyline{at(0, 0), at(0.2, 0.1), at(0.3, 0.4), at(0.1, 0.6)};
  const Polyline before = polyline;
  CHECK_FALSE(erase_loops(polyline));
  CHECK(polyline == before);
}

TEST_CASE("a loop is erased up to the intersection that closes it") {
  Polyline polyline{at(0, 0), at(0.4, 0), at(0.4, 0.2), at(0.2, 0.2), at(0.2, -0.2), at(0.5, -0.3)};
  CHECK(erase_loops(polyline));
  REQUIRE(polyline.size() == 4);
  CHECK(polyline[1][1] == Approx(0.2));
  CHECK(polyline[1][2] == Approx(0).margin(1e-15));
  CHECK(polyline.back() == at(0.5, -0.3));
}

TEST_CASE("points that alternate between the two sides of a sharp corner: the result is simple and keeps its ends") {
  test::Random random(2);
  for (int round = 0; round < 300; ++round) {
    Polyline polyline;
    for (int i = 0; i <= 10; ++i) polyline.push_back(at(0.05 * i, 0.1));
    for (int i = random.below(30); i >= 0; --i) {
      const double x = random.real(0.3, 0.6);
      polyline.push_back(at(x, random.below(2) == 0 ? 0.1 + 0.01 * (x - 0.3) : 0.2 - 0.2 * (x - 0.3)));
    }
    for (int i = 10; i >= 0; --i) polyline.push_back(at(0.05 * i, 0.2));
    const Polyline before = polyline;
    INFO("round " << round);
    const bool had_loops = intersects_itself(before);
    REQUIRE(erase_loops(polyline) == had_loops);
    REQUIRE_FALSE(intersects_itself(polyline));
    REQUIRE(polyline.front() == before.front());
    REQUIRE(polyline.back() == before.back());
  }
}

TEST_CASE("a polyline of more than 1000 points does not change") {
  Polyline polyline;
  for (int i = 0; i < 2000; ++i) polyline.push_back(at(0.1 + 0.1 * (i % 3), 0.1 + 0.1 * (i % 2)));
  CHECK_FALSE(erase_loops(polyline));
  CHECK(polyline.size() == 2000);
}

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
