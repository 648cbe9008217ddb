// Growing ends: exits, intersections, the way around an edge, the order of events, and branch points.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "diagram/growth/growing_end.hpp"
#include "geodesic/face_layout.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_growing_end {

const std::array<Vec2, 3> kCorner{Vec2(0, 0), Vec2(4, 0), Vec2(0, 4)};

GrowingEnd end_at(const Vec2& start, const Vec2& left_image, const Vec2& right_image) {
  return {FaceId(0), 0, start, GeneratorId(0), GeneratorId(1), left_image, right_image};
}

TEST_CASE("an end grows along the bisector of its images, the left one on its left") {
  const GrowingEnd end = end_at({1, 1}, {0, 1}, {2, 1});
  CHECK((end.direction - Vec2(0, 1)).norm() < 1e-15);
  CHECK(end.distance_at({1, 3}) == Approx(std::hypot(1, 2)));
  CHECK((end_at({1, 1}, {2, 1}, {0, 1}).direction - Vec2(0, -1)).norm() < 1e-15);
}

TEST_CASE("an end leaves its face by the first edge on its way") {
  const auto up = find_exit(end_at({1, 0}, {0, 0}, {2, 0}), kCorner);
  REQUIRE(up);
  CHECK(up->halfedge == Mesh::halfedge(FaceId(0), 1));
  CHECK((up->point - Vec2(1, 3)).norm() < 1e-15);
  CHECK(up->t == Approx(0.75));
  CHECK(up->distance == Approx(std::hypot(1, 3)));
  const auto left = find_exit(end_at({1, 1}, {1, 0}, {1, 2}), kCorner);
  REQUIRE(left);
  CHECK(left->halfedge == Mesh::halfedge(FaceId(0), 2));
  CHECK(left->t == Approx(0.75));
}

TEST_CASE("an end whose images coincide has no direction and no exit") {
  CHECK_FALSE(find_exit(end_at({1, 1}, {2, 2}, {2, 2}), kCorner));
}

TEST_CASE("two ends intersect where both get to before they leave the face, if they approach each other") {
  GrowingEnd first = end_at({0.5, 0}, {0, 0.5}, {1, -0.5});   // up and to the right
  GrowingEnd second = end_at({2.5, 0}, {2, -0.5}, {3, 0.5});  // up and to the left
  GrowingEnd parallel = end_at({2.5, 0}, {2, 0.5}, {3, -0.5});
  for (GrowingEnd* end : {&first, &second, &parallel}) end->exit = find_exit(*end, kCorner);
  const auto intersection = find_intersection(first, second);
  REQUIRE(intersection);
  CHECK((*intersection - Vec2(1.5, 1)).norm() < 1e-12);
  CHECK_FALSE(find_intersection(second, first));  // in this order they move apart
  CHECK_FALSE(find_intersection(first, parallel));
  second.exit.reset();
  CHECK_FALSE(find_intersection(first, second));
}

TEST_CASE("the rotation around an edge takes the edge to the edge and keeps lengths and sides") {
  const EdgeRotation rotate({1, 2}, {4, 6}, {0, 0}, {5, 0});
  CHECK((rotate({1, 2}) - Vec2(0, 0)).norm() < 1e-14);
  CHECK((rotate({4, 6}) - Vec2(5, 0)).norm() < 1e-14);
  CHECK((rotate(Vec2(1, 2) + turned_left({0.6, 0.8})) - Vec2(0, 1)).norm() < 1e-14);
}

TEST_CASE("over an edge a direction keeps its parts along the edge and across it: equations (7) to (10)") {
  const Mesh mesh = test::make_bumpy_sphere(1, 3);
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    const int i = Mesh::corner(h), j = Mesh::corner(twin);
    const FaceLayout old_face(mesh, Mesh::face(h)), new_face(mesh, Mesh::face(twin));
    const EdgeRotation rotate(old_face.corner[i], old_face.corner[(i + 1) % 3], new_face.corner[(j + 1) % 3],
                              new_face.corner[j]);
    // The layout of a face has its first side as its first axis, and its normal points to the reader.
    const auto in_space = [&](FaceId f, const Vec2& d) {
      const auto& [a, b, c] = mesh.vertices(f);
      const Vec3 u = (mesh.position(b) - mesh.position(a)).normalized();
      const Vec3 n = u.cross(mesh.position(c) - mesh.position(a)).normalized();
      return std::pair(Vec3(d.x() * u + d.y() * n.cross(u)), n);
    };
    for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-2, 3)}) {
      const auto [pq, n1] = in_space(Mesh::face(h), d);
      const auto [turned, n2] = in_space(Mesh::face(twin), rotate.turn(d));
      const Vec3 along = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).normalized();
      const Vec3 expected = pq.dot(along) * along + pq.dot(n1.cross(along)) * n2.cross(along);
      REQUIRE((turned - expected).norm() < 1e-12);
    }
  }
}

TEST_CASE("an end on an edge that runs along it does not leave by it") {
  const auto along = find_exit(end_at({1, 0}, {2, 1}, {2, -1}), kCorner);  // along the first edge
  REQUIRE(along);
  CHECK(along->halfedge == Mesh::halfedge(FaceId(0), 1));
  CHECK(along->t == Approx(0).margin(1e-15));
}

TEST_CASE("an end that starts a rounding error outside leaves where it is") {
  const auto exit = find_exit(end_at({-1e-17, 2}, {0, 1}, {0, 3}), kCorner);  // to the left
  REQUIRE(exit);
  CHECK(exit->halfedge == Mesh::halfedge(FaceId(0), 2));
  CHECK((exit->point - Vec2(0, 2)).norm() < 1e-15);
}

using Kind = GrowthEvent::Kind;

/// The first ends of the events, in the order in which they are handled.
std::vector<std::size_t> order_of(EventOrder order, const std::vector<GrowthEvent>& pushed) {
  GrowthEvents events(order);
  for (const GrowthEvent& e : pushed) events.push(e);
  std::vector<std::size_t> popped;
  while (!events.empty()) popped.push_back(events.pop().first);
  return popped;
}

const std::vector<GrowthEvent> kMixed{{Kind::exit, 1, 0, kNoEnd},      {Kind::intersection, 3, 1, 2},
                                      {Kind::joining, 9, 3, 4},        {Kind::exit, 2, 5, kNoEnd},
                                      {Kind::intersection, 1.5, 6, 7}, {Kind::joining, 8, 8, 9}};

TEST_CASE("events by kind: joinings, intersections, exits, each by distance") {
  CHECK(order_of(EventOrder::by_kind, kMixed) == std::vector<std::size_t>{8, 3, 6, 1, 0, 5});
}

TEST_CASE("events by distance: joinings, then intersections and exits in one order") {
  CHECK(order_of(EventOrder::by_distance, kMixed) == std::vector<std::size_t>{8, 3, 0, 6, 5, 1});
}

TEST_CASE("events that tie come in the order of their ends, however they were pushed") {
  const std::vector<GrowthEvent> ties{
      {Kind::exit, 1, 2, kNoEnd}, {Kind::exit, 1, 0, kNoEnd}, {Kind::exit, 1, 1, kNoEnd}};
  for (const EventOrder order : {EventOrder::by_kind, EventOrder::by_distance}) {
    CHECK(order_of(order, ties) == std::vector<std::size_t>{0, 1, 2});
    CHECK(order_of(order, {ties[1], ties[2], ties[0]}) == std::vector<std::size_t>{0, 1, 2});
  }
}

/// Two ends in the face of a flat grid that holds the circumcentre of three generators, with the generators' true
/// positions as images.
struct TwoEnds {
  static constexpr int kSquares = 16;
  static int at(int i, int j) { return j * (kSquares + 1) + i; }

  Mesh mesh = test::make_grid(kSquares, kSquares);
  test::Stages stages;
  GrowingEnd first{}, second{};
  Vec2 centre;

  explicit TwoEnds(std::vector<int> generators = {at(3, 3), at(13, 3), at(8, 13)})
      : stages(mesh, test::at_vertices(mesh, generators), Front::circle) {
    // (8, 6.75) is at the distance 6.25 from (3, 3), (13, 3) and (8, 13).
    const FaceId f(2 * (6 * kSquares + 8));
    first.face = second.face = f;
    first.left = GeneratorId(0);
    first.right = second.left = GeneratorId(1);
    second.right = GeneratorId(2);
    first.left_image = in_plane(3, 3);
    first.right_image = second.left_image = in_plane(13, 3);
    second.right_image = in_plane(8, 13);
    centre = in_plane(8, 6.75);
  }

  /// A point of the grid in the plane of the face.
  Vec2 in_plane(double x, double y) const {
    const FaceLayout layout(mesh, first.face.valid() ? first.face : FaceId(2 * (6 * kSquares + 8)));
    const auto& [a, b, c] = mesh.vertices(FaceId(2 * (6 * kSquares + 8)));
    const Vec3 &pa = mesh.position(a), u = mesh.position(b) - pa, v = mesh.position(c) - pa, w = Vec3(x, y, 0) - pa;
    const double area = u.cross(v).z(), s = w.cross(v).z() / area, t = u.cross(w).z() / area;
    return layout.at({1 - s - t, s, t});
  }
};

TEST_CASE("the distance of a branch point is the mean of its three generators'") {
  const TwoEnds ends;
  CHECK(branch_distance(ends.first, ends.second, ends.centre) == Approx(6.25));
  // A point off the centre: the three count the same.
  const double mean = (std::hypot(5, 5) + std::hypot(5, 5) + 5) / 3;
  CHECK(branch_distance(ends.first, ends.second, ends.in_plane(8, 8)) == Approx(mean));
}

TEST_CASE("a branch point has to be equally far from its three generators") {
  const TwoEnds ends;
  CHECK(accept_branch(ends.stages.input(), ends.first, ends.second, ends.centre));
  CHECK(accept_branch(ends.stages.input(), ends.first, ends.second, ends.in_plane(8, 6.9)));
  CHECK_FALSE(accept_branch(ends.stages.input(), ends.first, ends.second, ends.in_plane(8, 7.5)));
}

TEST_CASE("a branch point has to be farther from all other generators") {
  const int near = TwoEnds::at(8, 5);
  const TwoEnds ends({TwoEnds::at(3, 3), TwoEnds::at(13, 3), TwoEnds::at(8, 13), near});
  CHECK_FALSE(accept_branch(ends.stages.input(), ends.first, ends.second, ends.centre));
}

}  // namespace gvd::test_growing_end
