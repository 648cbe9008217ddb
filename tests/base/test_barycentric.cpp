#include <vector>

#include "base/barycentric.hpp"
#include "support/catch.hpp"

namespace gvd::test_barycentric {

using Polygon = std::vector<Bary>;

TEST_CASE("mix keeps both ends to the last bit and the sum of the weights") {
  const Bary a{0.1, 0.2, 0.7}, b{0.3, 0.3, 0.4};
  CHECK(mix(a, b, 0) == a);
  CHECK(mix(a, b, 1) == b);
  const Bary middle = mix(a, b, 0.5);
  CHECK(middle[0] == Approx(0.2));
  CHECK(middle[0] + middle[1] + middle[2] == Approx(1));
  CHECK(mix({1, 0, 0}, {0, 1, 0}, 0.25)[2] == 0);
}

TEST_CASE("interpolate gives a corner's value at the corner, of numbers and of points") {
  CHECK(interpolate({1, 0, 0}, 3.0, 5.0, 7.0) == 3);
  CHECK(interpolate({0, 0, 1}, 3.0, 5.0, 7.0) == 7);
  CHECK(interpolate({0.25, 0.25, 0.5}, Vec2(0, 0), Vec2(4, 0), Vec2(0, 2)) == Vec2(1, 1));
  CHECK(interpolate({0, 1, 0}, Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9)) == Vec3(4, 5, 6));
}

TEST_CASE("affine_point keeps the orientation of a face") {
  CHECK(twice_signed_area(affine_point({1, 0, 0}), affine_point({0, 1, 0}), affine_point({0, 0, 1})) == 1);
}

TEST_CASE("area_share: the whole face, half of it, and clockwise") {
  CHECK(area_share(Polygon{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == 1);
  CHECK(area_share(Polygon{{1, 0, 0}, {0.5, 0.5, 0}, {0, 0, 1}}) == 0.5);
  CHECK(area_share(Polygon{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}) == -1);
  CHECK(area_share(Polygon{{1, 0, 0}, {0, 1, 0}}) == 0);
  CHECK(area_share(Polygon{}) == 0);
}

}  // namespace gvd::test_barycentric
