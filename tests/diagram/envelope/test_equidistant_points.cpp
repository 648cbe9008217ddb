#include <algorithm>
#include <cmath>

#include "diagram/envelope/equidistant_points.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/random.hpp"

namespace gvd::test_equidistant_points {

FaceSource source(const Vec2& image, double offset) {
  return test::through_side(0, 0, image, {image + Vec2(1, 1), image + Vec2(1, -1)}, offset);
}

std::vector<Vec2> equidistant_points(const std::vector<FaceSource>& a, const std::vector<FaceSource>& b,
                                     const std::vector<FaceSource>& c) {
  std::vector<Vec2> points;
  append_equidistant_points(a, b, c, points);
  return points;
}

double nearest_to(const std::vector<Vec2>& points, const Vec2& p) {
  double least = 1e300;
  for (const Vec2& q : points) least = std::min(least, (q - p).norm());
  return least;
}

TEST_CASE("a point to which three images are equally far is found, whatever their offsets") {
  test::Random random(4);
  const auto anywhere = [&] { return Vec2(random.real(-1, 1), random.real(-1, 1)); };
  for (int round = 0; round < 2000; ++round) {
    const Vec2 p = anywhere();
    std::vector<FaceSource> one[3];
    for (auto& sources : one) {
      const Vec2 image = 3 * anywhere();
      sources.push_back(source(image, 8 - (p - image).norm()));
    }
    INFO("round " << round);
    REQUIRE(nearest_to(equidistant_points(one[0], one[1], one[2]), p) < 1e-7);
  }
}

TEST_CASE("collinear images and equal offsets have finite points") {
  const std::vector<FaceSource> a{source({0, 0}, 0)}, b{source({2, 0}, 0)}, c{source({0, 2}, 0)},
      d{source({3, 0}, 0.5)};
  CHECK(nearest_to(equidistant_points(a, b, c), {1, 1}) < 1e-12);
  for (const Vec2& p : equidistant_points(a, b, d)) CHECK(p.allFinite());
  // On the line half way between the first two, sqrt(1 + y^2) + 1/2 = sqrt(4 + y^2).
  const std::vector<FaceSource> near{source({0, 0}, 0.5)}, other{source({2, 0}, 0.5)}, far{source({3, 0}, 0)};
  bool equal = false;
  for (const Vec2& p : equidistant_points(near, other, far)) {
    const double first = 0.5 + p.norm(), third = (p - Vec2(3, 0)).norm();
    equal = equal || std::abs(first - third) < 1e-12;
  }
  CHECK(equal);
}

TEST_CASE("every triple of sources is solved, and three equal ones have no point") {
  const std::vector<FaceSource> a{source({0, 0}, 0), source({-4, 1}, 0)}, b{source({2, 0}, 0)},
      c{source({0, 2}, 0), source({5, -3}, 0)};
  CHECK(equidistant_points(a, b, c).size() == 8);
  CHECK(equidistant_points(b, b, b).empty());
}

}  // namespace gvd::test_equidistant_points
