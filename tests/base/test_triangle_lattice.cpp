// The lattice of a triangle: how many points and triangles, in which order, and that they cover it once.
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "base/triangle_lattice.hpp"
#include "support/catch.hpp"

namespace gvd::test_triangle_lattice {

using Point = std::pair<int, int>;

std::vector<Point> points_of(int k) {
  std::vector<Point> points;
  for_each_lattice_point(k, [&](int i, int j) { points.emplace_back(i, j); });
  return points;
}

std::vector<std::array<Point, 3>> triangles_of(int k) {
  std::vector<std::array<Point, 3>> triangles;
  for_each_lattice_triangle(k, [&](int i, int j, bool is_upright) {
    if (is_upright) triangles.push_back({{{i, j}, {i + 1, j}, {i, j + 1}}});
    if (!is_upright) triangles.push_back({{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}});
  });
  return triangles;
}

TEST_CASE("lattice: a triangle that is not cut has its corners, and itself") {
  CHECK(points_of(1) == std::vector<Point>{{0, 0}, {0, 1}, {1, 0}});
  CHECK(triangles_of(1) == std::vector<std::array<Point, 3>>{{{{0, 0}, {1, 0}, {0, 1}}}});
}

TEST_CASE("lattice: sides in two parts give four triangles, the second one the other way up") {
  const auto triangles = triangles_of(2);
  REQUIRE(triangles.size() == 4);
  CHECK(triangles[1] == std::array<Point, 3>{{{1, 1}, {0, 1}, {1, 0}}});
}

TEST_CASE("lattice: points are numbered in their order, without a gap") {
  for (int k = 1; k < 9; ++k) {
    const std::vector<Point> points = points_of(k);
    CHECK(points.size() == std::size_t((k + 1) * (k + 2) / 2));
    for (std::size_t n = 0; n < points.size(); ++n) {
      CHECK(lattice_number(k, points[n].first, points[n].second) == int(n));
    }
  }
}

TEST_CASE("lattice: k * k triangles of one orientation, each side in one triangle a direction") {
  for (int k = 1; k < 9; ++k) {
    const auto triangles = triangles_of(k);
    CHECK(triangles.size() == std::size_t(k * k));
    std::set<std::pair<Point, Point>> sides;
    for (const auto& t : triangles) {
      for (std::size_t n = 0; n < 3; ++n) {
        CHECK(t[n].first + t[n].second <= k);
        CHECK(sides.insert({t[n], t[(n + 1) % 3]}).second);
      }
    }
  }
}

}  // namespace gvd::test_triangle_lattice
