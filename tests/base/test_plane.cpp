#include <array>
#include <cmath>
#include <vector>

#include "base/plane.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_plane {

/// Exact sign of an orientation of integer points.
int exact_orientation(const std::array<long long, 6>& p) {
  const long long area = (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
  return (area > 0) - (area < 0);
}

TEST_CASE("cross and turned_left are counter-clockwise positive") {
  CHECK(cross({1, 0}, {0, 1}) == 1);
  CHECK(cross({0, 1}, {1, 0}) == -1);
  CHECK(cross({2, 3}, {4, 6}) == 0);
  CHECK(turned_left({1, 0}) == Vec2(0, 1));
  CHECK(turned_left({3, 4}) == Vec2(-4, 3));
}

TEST_CASE("unit_vector counts angles counter-clockwise from the x axis") {
  CHECK(unit_vector(0) == Vec2(1, 0));
  CHECK((unit_vector(std::acos(-1.0) / 2) - Vec2(0, 1)).norm() < 1e-15);
}

TEST_CASE("twice_signed_area changes its sign with the direction and keeps it under rotation of the corners") {
  const Vec2 a(0, 0), b(3, 0), c(1, 2);
  CHECK(twice_signed_area(a, b, c) == 6);
  CHECK(twice_signed_area(b, c, a) == 6);
  CHECK(twice_signed_area(a, c, b) == -6);
  CHECK(twice_signed_area(a, b, Vec2(7, 0)) == 0);
}

TEST_CASE("twice_signed_area of a polygon: concave, clockwise, and of fewer than three corners") {
  const auto area_of = [](const std::vector<Vec2>& polygon) {
    return twice_signed_area(polygon.size(), [&](std::size_t i) { return polygon[i]; });
  };
  CHECK(area_of({}) == 0);
  CHECK(area_of({{1, 2}}) == 0);
  CHECK(area_of({{1, 2}, {3, 5}}) == 0);
  CHECK(area_of({{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}) == 6);
  CHECK(area_of({{0, 2}, {1, 1}, {2, 2}, {2, 0}, {0, 0}}) == -6);
}

TEST_CASE("orientation: left, right, and open on the line") {
  CHECK(orientation({0, 0}, {1, 0}, {0.5, 1e-300}) == 1);
  CHECK(orientation({0, 0}, {1, 0}, {0.5, -1e-300}) == -1);
  CHECK(orientation({0, 0}, {1, 0}, {2, 0}) == 0);
  CHECK(orientation({1, 1}, {1, 1}, {2, 0}) == 0);
}

TEST_CASE("orientation: rounding never gives the wrong sign, and leaves only near ties open") {
  test::Random random(11);
  int open = 0;
  for (int round = 0; round < 20000; ++round) {
    // Three integer points near a line: their products exceed the 53 bits of a double and fit into 64.
    std::array<long long, 6> p{};
    std::array<Vec2, 3> point;
    const long long dx = random.below(1 << 20), dy = random.below(1 << 20);
    for (std::size_t i = 0; i < 3; ++i) {
      const long long along = random.below(900);
      p[2 * i] = along * dx + random.below(2);
      p[2 * i + 1] = along * dy + random.below(2);
      point[i] = Vec2(static_cast<double>(p[2 * i]), static_cast<double>(p[2 * i + 1]));
    }
    const int side = orientation(point[0], point[1], point[2]), expected = exact_orientation(p);
    INFO("round " << round);
    REQUIRE((side == 0 || side == expected));
    REQUIRE(orientation(point[1], point[0], point[2]) * expected <= 0);
    if (side == 0 && expected != 0) ++open;
  }
  CHECK(open < 200);
}

constexpr double kTolerance = 1e-12;

/// All that the three predicates say, in every order of the ends and of the segments.
struct Answers {
  bool may, beyond, apart;
};

Answers ask(const PlaneSegment& a, const PlaneSegment& b) {
  const Answers answers{may_intersect(a, b), intersect_beyond(a, b, kTolerance),
                        lie_on_one_side(a, b.from, b.to) || lie_on_one_side(b, a.from, a.to)};
  const PlaneSegment a_reversed{a.to, a.from}, b_reversed{b.to, b.from};
  CHECK(may_intersect(b, a) == answers.may);
  CHECK(may_intersect(a_reversed, b) == answers.may);
  CHECK(may_intersect(a, b_reversed) == answers.may);
  CHECK(intersect_beyond(b, a, kTolerance) == answers.beyond);
  CHECK(intersect_beyond(a_reversed, b, kTolerance) == answers.beyond);
  CHECK(intersect_beyond(a, b_reversed, kTolerance) == answers.beyond);
  return answers;
}

TEST_CASE("intersect_lines gives both parameters of the common point") {
  const Vec2 p(1, 1), d(2, 0), q(2, 0), e(0, 4);
  const LineIntersection crossing = intersect_lines(p, d, q, e);
  CHECK(crossing.s == 0.5);
  CHECK(crossing.t == 0.25);
  CHECK((p + crossing.s * d) == (q + crossing.t * e));
}

TEST_CASE("intersect_lines of parallel lines is not finite") {
  CHECK_FALSE(std::isfinite(intersect_lines({0, 0}, {1, 1}, {1, 0}, {2, 2}).s));
  CHECK_FALSE(std::isfinite(intersect_lines({0, 0}, {1, 1}, {0, 0}, {2, 2}).t));
}

TEST_CASE("segments that cross properly") {
  const Answers answers = ask({{0, 0}, {1, 1}}, {{0, 1}, {1, 0}});
  CHECK(answers.may);
  CHECK(answers.beyond);
  CHECK_FALSE(answers.apart);
}

TEST_CASE("segments far from each other, with overlapping boxes and without") {
  for (const PlaneSegment& other : {PlaneSegment{{2, 2}, {3, 3}}, PlaneSegment{{0.6, 0.1}, {0.9, 0.5}}}) {
    const Answers answers = ask({{0, 0}, {1, 1}}, other);
    CHECK_FALSE(answers.may);
    CHECK_FALSE(answers.beyond);
  }
}

TEST_CASE("segments with a common end do not cross") {
  const Answers answers = ask({{0, 0}, {1, 1}}, {{1, 1}, {2, 0}});
  CHECK_FALSE(answers.may);
  CHECK_FALSE(answers.beyond);
}

TEST_CASE("one that ends on the other, or overlaps it, may cross and does not do so beyond the tolerance") {
  for (const PlaneSegment& other : {PlaneSegment{{0.5, 0}, {0.5, 1}}, PlaneSegment{{0.25, 0}, {0.75, 0}}}) {
    const Answers answers = ask({{0, 0}, {1, 0}}, other);
    CHECK(answers.may);
    CHECK_FALSE(answers.beyond);
  }
}

TEST_CASE("a crossing by less than the tolerance is no crossing beyond it") {
  CHECK_FALSE(intersect_beyond({{0, 0}, {1, 0}}, {{0.5, -1e-13}, {0.5, 1}}, kTolerance));
  CHECK(intersect_beyond({{0, 0}, {1, 0}}, {{0.5, -1e-11}, {0.5, 1}}, kTolerance));
}

TEST_CASE("random segments: crossing beyond rounding implies that they may cross and are not on one side") {
  test::Random random(4);
  int crossings = 0;
  for (int round = 0; round < 5000; ++round) {
    const auto point = [&] { return Vec2(random.real(0, 1), random.real(0, 1)); };
    const PlaneSegment a{point(), point()}, b{point(), point()};
    const auto [s, t] = intersect_lines(a.from, a.to - a.from, b.from, b.to - b.from);
    const bool expected = s > 1e-6 && s < 1 - 1e-6 && t > 1e-6 && t < 1 - 1e-6;
    const Answers answers = ask(a, b);
    if (expected) {
      ++crossings;
      REQUIRE(answers.may);
      REQUIRE_FALSE(answers.apart);
    }
    if (answers.beyond) REQUIRE((answers.may && !answers.apart));
    if (!answers.may) REQUIRE_FALSE(expected);
  }
  CHECK(crossings > 500);
}

TEST_CASE("an apex on the base's line is its own foot") {
  CHECK(apex_foot(2, 0, 2) == 0);
  CHECK(apex_foot(2, 2, 0) == 2);
  CHECK(apex_foot(2, 3, 1) == 3);
  CHECK(apex_foot(2, 1, 3) == -1);
}

TEST_CASE("the foot of an isosceles triangle is the middle of its base, however long its sides are") {
  for (const double side : {1.0, 1e3, 1e12}) CHECK(apex_foot(2, side, side) == 1);
}

TEST_CASE("the foot is where the coordinates say, by the base and by its inverse") {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double base = random.real(0.1, 3), x = random.real(-2, 5), y = random.real(0, 3);
    const double first = std::hypot(x, y), second = std::hypot(x - base, y);
    REQUIRE(apex_foot(base, first, second) == Approx(x).epsilon(1e-12).margin(1e-12));
    REQUIRE(apex_foot_by_inverse(base, 1 / base, first, second) == Approx(x).epsilon(1e-12).margin(1e-12));
  }
}

}  // namespace gvd::test_plane
