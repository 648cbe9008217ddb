// Signs of determinants that rounding leaves open, and pairs of faces with small whole coordinates against a search for
// a separating axis in whole numbers.
#include <algorithm>
#include <cmath>
#include <vector>

#include "dual/exact_predicates.hpp"
#include "dual/faces_intersect.hpp"
#include "dual/placed_faces.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_faces_intersect {

TEST_CASE("an expansion keeps what a double rounds off") {
  Expansion sum;
  CHECK(sum.sign() == 0);
  for (const double value : {1e100, 1.0, -1e100}) sum.add(value);
  CHECK(sum.sign() == 1);
  sum.add(-1 - 1e-16);
  CHECK(sum.sign() == 0);  // -1 - 1e-16 is rounded to -1 before the call
  sum.add(-1e-300);
  CHECK(sum.sign() == -1);
}

TEST_CASE("products of differences are exact") {
  const auto tiny = exact_difference(1, 1e-30);
  CHECK(tiny[0] == 1);
  CHECK(tiny[1] == -1e-30);
  Expansion square, cube;
  square.add_product(tiny, tiny, {1, 0});
  square.add(-1);
  CHECK(square.sign() == -1);
  square.add_product({2, 0}, {1e-30, 0}, {1, 0});
  CHECK(square.sign() == 1);  // (1 - x)^2 = 1 - 2 x + x^2
  cube.add_product(tiny, tiny, tiny);
  cube.add_product(negated(tiny), tiny, tiny);
  CHECK(cube.sign() == 0);
}

/// x + units in its last place.
double nudged(double x, int units) {
  for (; units > 0; --units) x = std::nextafter(x, 1e300);
  for (; units < 0; ++units) x = std::nextafter(x, -1e300);
  return x;
}

TEST_CASE("points one unit in the last place beside a line are on its sides") {
  const Vec2 a(12, 12), b(24, 24);
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      const Vec2 c(nudged(0.5, x), nudged(0.5, y));
      CHECK(exact_orientation(a, b, c) == (c.y() > c.x()) - (c.y() < c.x()));
    }
  }
}

TEST_CASE("points one unit in the last place beside a plane are on its sides") {
  // The plane x = y + z holds the first three points. All their coordinates are exact.
  const Vec3 a(0, 0, 0), b(24, 12, 12), c(17, 9, 8);
  CHECK(exact_orientation(a, b, c, Vec3(0.75, 0.5, 0.25)) == 0);
  for (int units = -3; units <= 3; ++units) {
    const Vec3 d(nudged(0.75, units), 0.5, 0.25);
    const int side = exact_orientation(a, b, c, d);
    CHECK(side == exact_orientation(a, b, c, Vec3(1, 0, 0)) * ((units > 0) - (units < 0)));
    CHECK(exact_orientation(b, a, c, d) == -side);
    CHECK(exact_orientation(d, b, c, a) == -side);
  }
}

TEST_CASE("a, b and c appear counter-clockwise from the positive side") {
  CHECK(exact_orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)) == 1);
  CHECK(exact_orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)) == -1);
  CHECK(exact_orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, -1)) == 0);
}

using Polygon = std::vector<Vec3>;

bool separates(const Vec3& axis, const Polygon& a, const Polygon& b) {
  const auto range = [&](const Polygon& polygon) {
    double low = axis.dot(polygon[0]), high = low;
    for (const Vec3& p : polygon) low = std::min(low, axis.dot(p)), high = std::max(high, axis.dot(p));
    return std::pair(low, high);
  };
  const auto [low_a, high_a] = range(a);
  const auto [low_b, high_b] = range(b);
  return high_a < low_b || high_b < low_a;
}

/// The normal of a polygon that is not degenerate; its corners are in a plane.
Vec3 normal(const Polygon& p) { return (p[1] - p[0]).cross(p[2] - p[0]); }

/// Whether two convex flat polygons have no common point. All numbers are whole and small, so nothing is rounded.
bool are_apart(const Polygon& a, const Polygon& b) {
  std::vector<Vec3> axes{normal(a), normal(b)};
  const auto edge = [](const Polygon& p, std::size_t i) -> Vec3 { return p[(i + 1) % p.size()] - p[i]; };
  for (std::size_t i = 0; i < a.size(); ++i) {
    axes.push_back(normal(a).cross(edge(a, i)));
    for (std::size_t j = 0; j < b.size(); ++j) axes.push_back(edge(a, i).cross(edge(b, j)));
  }
  for (std::size_t j = 0; j < b.size(); ++j) axes.push_back(normal(b).cross(edge(b, j)));
  return std::any_of(axes.begin(), axes.end(), [&](const Vec3& axis) { return separates(axis, a, b); });
}

/// The triangle without the half that touches corner 0.
Polygon without_corner(const Polygon& t) { return {t[1], t[2], (t[0] + t[2]) / 2, (t[0] + t[1]) / 2}; }

Vec3 random_point(test::Random& random) { return 2 * Vec3(random.below(5), random.below(5), random.below(5)); }

Polygon random_triangle(test::Random& random) {
  while (true) {
    Polygon t{random_point(random), random_point(random), random_point(random)};
    if (normal(t) != Vec3(0, 0, 0)) return t;
  }
}

bool intersect(const Polygon& positions, const std::array<int, 3>& f, const std::array<int, 3>& g) {
  return faces_intersect(test::make_mesh(positions, {f, g}), FaceId(0), FaceId(1));
}

/// For faces with the common corner 0. A third face between them makes them one fan.
bool intersect_beyond_corner(const Polygon& a, const Polygon& b) {
  const std::vector<std::array<int, 3>> fan{{0, 1, 2}, {0, 3, 4}, {0, 2, 3}};
  return faces_intersect(test::make_mesh({a[0], a[1], a[2], b[1], b[2]}, fan), FaceId(0), FaceId(1));
}

TEST_CASE("faces without a common vertex intersect where no axis separates them") {
  test::Random random(1);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const Polygon a = random_triangle(random), b = random_triangle(random);
    const bool meet = intersect({a[0], a[1], a[2], b[0], b[1], b[2]}, {0, 1, 2}, {3, 4, 5});
    REQUIRE(meet == !are_apart(a, b));
    found += meet;
  }
  CHECK(found > 5000);
  CHECK(found < 15000);
}

TEST_CASE("faces of one vertex intersect where an outer half of one meets the other") {
  test::Random random(2);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const Polygon a = random_triangle(random);
    Polygon b = random_triangle(random);
    b[0] = a[0];
    if (normal(b) == Vec3(0, 0, 0) || b[1] == a[2]) continue;
    const bool meet = intersect_beyond_corner(a, b);
    REQUIRE(meet == !(are_apart(without_corner(a), b) && are_apart(a, without_corner(b))));
    found += meet;
  }
  CHECK(found > 3000);
  CHECK(found < 15000);
}

TEST_CASE("faces of one edge intersect only where they are folded onto each other") {
  const Vec3 a(0, 0, 0), b(2, 0, 0), c(1, 1, 0);
  const auto folds = [&](const Vec3& d) { return intersect({a, b, c, d}, {0, 1, 2}, {1, 0, 3}); };
  CHECK(folds({1, 2, 0}));
  CHECK(folds({-5, 0.5, 0}));
  CHECK(folds(c));
  CHECK_FALSE(folds({1, -1, 0}));
  CHECK_FALSE(folds({1, 1, 1e-300}));
  CHECK_FALSE(folds({1, 0, 1}));
}

TEST_CASE("faces of the same three vertices intersect") {
  CHECK(faces_intersect(test::make_pillow(), FaceId(0), FaceId(1)));
}

TEST_CASE("a segment meets triangles without area, and a point of them") {
  const Triangle line{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)}, point{Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)};
  CHECK(segment_meets_triangle({2, 2, 0}, {2, 2, 4}, line));
  CHECK(segment_meets_triangle({2, 2, 2}, {9, 9, 9}, line));
  CHECK_FALSE(segment_meets_triangle({4, 4, 4}, {9, 9, 9}, line));
  CHECK_FALSE(segment_meets_triangle({2, 2.5, 0}, {2, 2.5, 4}, line));
  CHECK(segment_meets_triangle({0, 0, 0}, {2, 2, 2}, point));
  CHECK_FALSE(segment_meets_triangle({0, 0, 0}, {2, 2, 2.5}, point));
}

}  // namespace gvd::test_faces_intersect
