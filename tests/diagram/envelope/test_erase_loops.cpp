#include <cmath>

#include "base/barycentric.hpp"
#include "diagram/envelope/arc_intersections.hpp"
#include "diagram/envelope/erase_loops.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_erase_loops {

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

}  // namespace gvd::test_erase_loops
