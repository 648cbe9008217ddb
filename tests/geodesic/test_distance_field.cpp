#include <cmath>

#include "geodesic/distance_field.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/random.hpp"

namespace gvd::test_distance_field {

/// The image (1, -1) behind an opening from (0.5, 0) to (1.5, 0), 0.25 from the generator.
FaceSource make_source() { return test::through_side(0, 0, {1, -1}, {{0.5, 0}, {1.5, 0}}, 0.25); }

TEST_CASE("an edge source at one end of its edge, and one whose interval is a point") {
  const EdgeSource end{0, 2, 0, 0, 0.5, GeneratorId(0)};
  CHECK(end.distance(0) == 0.5);
  CHECK(end.distance(2) == 2.5);
  const EdgeSource point{1, 1, 1, 3, 0, GeneratorId(0)};
  CHECK(point.distance(1) == 3);
  CHECK(point.distance(0) == 4);
  CHECK(point.distance(2) == 4);
}

TEST_CASE("the path of an edge source is straight inside its interval and follows the edge beyond, continuously") {
  const EdgeSource s{0.5, 1.5, 1, 1, 0.25, GeneratorId(0)};
  CHECK(s.distance(1) == 1.25);
  CHECK(s.distance(0) == s.straight(0.5) + 0.5);
  CHECK(s.distance(2) == s.straight(1.5) + 0.5);
  for (const double t : {0.5, 1.5}) CHECK(std::abs(s.distance(t - 1e-9) - s.distance(t + 1e-9)) < 3e-9);
}

TEST_CASE("the path from a corner is straight everywhere") {
  const FaceSource s = test::from_corner(0, 0, {0, 0}, 2);
  const auto path = s.shortest_path({3, 4});
  CHECK(path.distance == 7);
  CHECK(path.from == Vec2(0, 0));
  CHECK(s.entry({3, 4}) == Vec2(0, 0));
}

TEST_CASE("the path through an opening is straight where the image sees the point, and bends at its ends elsewhere") {
  const FaceSource s = make_source();
  CHECK(s.distance({1, 1}) == 2.25);
  CHECK(s.shortest_path({1, 1}).from == s.image);
  CHECK(s.shortest_path({-1, 1}).from == s.begin);
  CHECK(s.distance({-1, 1}) == Approx(0.25 + std::hypot(0.5, 1) + std::hypot(1.5, 1)).epsilon(1e-15));
  CHECK(s.shortest_path({3, 1}).from == s.end);
}

TEST_CASE("no path is shorter than the straight line from the image, and the length is continuous") {
  const FaceSource s = make_source();
  test::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p(random.real(-2, 4), random.real(0, 3)), q = p + Vec2(random.real(-1, 1), random.real(0, 1)) * 1e-6;
    REQUIRE(s.distance(p) >= 0.25 + (p - s.image).norm() - 1e-12);
    REQUIRE(std::abs(s.distance(p) - s.distance(q)) <= (p - q).norm() * (1 + 1e-9) + 1e-15);
  }
}

TEST_CASE("a path enters where it crosses the opening, or at the end that it bends round") {
  const FaceSource s = make_source();
  CHECK((s.entry({1, 1}) - Vec2(1, 0)).norm() < 1e-15);
  CHECK((s.entry({1.5, 1}) - Vec2(1.25, 0)).norm() < 1e-15);
  CHECK(s.entry({-1, 1}) == s.begin);
  CHECK(s.entry({3, 1}) == s.end);
}

}  // namespace gvd::test_distance_field
