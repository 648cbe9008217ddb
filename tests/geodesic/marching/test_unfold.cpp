#include <cmath>

#include "geodesic/marching/unfold.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_unfold {

TEST_CASE("distances that no triangle has unfold to the line through the two points") {
  CHECK(unfold_source({0, 0}, {1, 0}, 0.2, 0.2).y() == 0);
  CHECK(unfold_source({0, 0}, {1, 0}, 3, 1).y() == 0);
  CHECK(unfold_source({0, 0}, {1, 0}, 0, 0) == Vec2(0.5, 0));
}

TEST_CASE("a source at one of the two points unfolds to that point") {
  CHECK((unfold_source({1, 1}, {1, 3}, 0, 2) - Vec2(1, 1)).norm() == 0);
  CHECK((unfold_source({1, 1}, {1, 3}, 2, 0) - Vec2(1, 3)).norm() == 0);
}

TEST_CASE("an image lies on the right of the edge, at the two distances") {
  test::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 a(random.real(-2, 2), random.real(-2, 2)), b(random.real(-2, 2), random.real(-2, 2));
    if ((b - a).norm() < 0.1) continue;
    const Vec2 source = a + random.real(-1, 2) * (b - a) - random.real(0.1, 2) * turned_left(b - a);
    const Vec2 image = unfold_source(a, b, (source - a).norm(), (source - b).norm());
    REQUIRE((image - source).norm() < 1e-9);
    REQUIRE(cross(b - a, image - a) < 0);
  }
}

TEST_CASE("a generator unfolds over the side that its front enters through") {
  const std::array<Vec2, 3> corner{Vec2(0, 0), Vec2(2, 0), Vec2(0.5, 1.5)};
  test::Random random(6);
  for (int i = 0; i < 500; ++i) {
    // Close behind the middle of side 1, so that its two corners are the nearest ones.
    const Vec2 source = Vec2(1.25, 0.75) + random.real(0.05, 0.3) * Vec2(1, 1) + random.real(-0.1, 0.1) * Vec2(-1, 1);
    std::array<double, 3> distance{};
    for (std::size_t k = 0; k < 3; ++k) distance[k] = (source - corner[k]).norm();
    REQUIRE((unfold_generator(corner, distance) - source).norm() < 1e-9);
  }
}

}  // namespace gvd::test_unfold
