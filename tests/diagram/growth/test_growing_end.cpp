// The events of growth: exits, intersections, and the way around an edge.
#include <array>
#include <cmath>

#include "diagram/growth/growing_end.hpp"
#include "support/catch.hpp"

namespace gvd::test_growing_end {

const std::array<Vec2, 3> kCorner{Vec2(0, 0), Vec2(4, 0), Vec2(0, 4)};

GrowingEnd end_at(const Vec2& start, const Vec2& left_image, const Vec2& right_image) {
  return {FaceId(0), 0, start, GeneratorId(0), GeneratorId(1), left_image, right_image};
}

TEST_CASE("an end grows along the bisector of its images, the left one on its left") {
  const GrowingEnd end = end_at({1, 1}, {0, 1}, {2, 1});
  CHECK((end.direction() - Vec2(0, 1)).norm() < 1e-15);
  CHECK(end.distance_at({1, 3}) == Approx(std::hypot(1, 2)));
  CHECK((end_at({1, 1}, {2, 1}, {0, 1}).direction() - Vec2(0, -1)).norm() < 1e-15);
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

}  // namespace gvd::test_growing_end
