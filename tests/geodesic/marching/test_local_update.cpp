// The numbered properties of geodesic/local_update.hpp, over seeded random triangles.
#include <algorithm>
#include <cmath>
#include <optional>

#include "geodesic/marching/local_update.hpp"
#include "gvd/vec.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_local_update {

/// The frame of the triangle A = (0, 0), B = (base, 0), D.
UpdateTriangle triangle_of(double base, const Vec2& d) {
  return make_update_triangle(base, d.norm(), (d - Vec2(base, 0)).norm(), base * d.y());
}

UpdateTriangle mirrored(const UpdateTriangle& t) {
  return make_update_triangle(t.base, t.side_b, t.side_a, t.base * t.height);
}

/// Where the line from p (below the base) to q (above it) crosses the base's line.
double crossing(const Vec2& p, const Vec2& q) { return p.x() + (q.x() - p.x()) * p.y() / (p.y() - q.y()); }

struct Sample {
  double base;
  Vec2 d, source;
};

Sample random_sample(test::Random& random) {
  const double base = random.real(0.2, 3);
  return {base, {random.real(-2, 4), random.real(0.05, 3)}, {random.real(-4, 6), random.real(-4, -0.05)}};
}

bool sees(const Sample& s) {
  const double x = crossing(s.source, s.d);
  return x > 1e-6 && x < s.base - 1e-6;
}

constexpr int kRounds = 20000;

TEST_CASE("the frame of a triangle has its foot and height") {
  const UpdateTriangle t = triangle_of(2, {0.5, 1.5});
  CHECK(t.x == Approx(0.5));
  CHECK(t.height == Approx(1.5));
  CHECK(t.base * t.inverse_base == Approx(1));
  CHECK(triangle_of(2, {-1, 0.5}).x == Approx(-1));  // obtuse at A: the foot lies before it
  CHECK(make_update_triangle(2, 1.5, 0.5, 0).height == 0);
  CHECK(make_update_triangle(2, 1.5, 0.5, 0).x == Approx(1.5));
}

TEST_CASE("(1) both updates are symmetric in A and B") {
  test::Random random(1);
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = random.real(0, 4), b = random.real(0, 4);
    REQUIRE(update_circle(t, a, b) == Approx(update_circle(mirrored(t), b, a)).epsilon(1e-9));
    REQUIRE(update_planar(t, a, b) == Approx(update_planar(mirrored(t), b, a)).epsilon(1e-9));
    REQUIRE(update_along_edges(t, a, b) == Approx(update_along_edges(mirrored(t), b, a)).epsilon(1e-12));
  }
}

TEST_CASE(
    "(2) the circle is exact for a planar point source that sees D through A B, and falls back to the edges (3)") {
  test::Random random(2);
  int seen = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = s.source.norm(), b = (s.source - Vec2(s.base, 0)).norm();
    const double x = crossing(s.source, s.d);
    if (sees(s)) {
      ++seen;
      REQUIRE(update_circle(t, a, b) == Approx((s.d - s.source).norm()).epsilon(1e-11));
    } else if (x < -1e-6 || x > s.base + 1e-6) {
      REQUIRE(update_circle(t, a, b) == update_along_edges(t, a, b));
    }
  }
  CHECK(seen > kRounds / 20);
  CHECK(seen < kRounds);
}

TEST_CASE("(2) the planar front is exact for a plane wave that passes A B on its way to D") {
  test::Random random(3);
  int seen = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double angle = random.real(-1.5, 1.5);
    const Vec2 way(std::sin(angle), std::cos(angle));
    const double start = 5, a = start, b = start + way.x() * s.base;
    const double x = s.d.x() - s.d.y() * way.x() / way.y();
    if (x > 1e-6 && x < s.base - 1e-6) {
      ++seen;
      REQUIRE(update_planar(t, a, b) == Approx(start + way.dot(s.d)).epsilon(1e-12));
    } else if (x < -1e-6 || x > s.base + 1e-6) {
      REQUIRE(update_planar(t, a, b) == update_along_edges(t, a, b));
    }
  }
  CHECK(seen > kRounds / 20);
  CHECK(seen < kRounds);
}

TEST_CASE("(3) distances that break the triangle inequality fall back to the edges") {
  const UpdateTriangle t = triangle_of(1, {0.4, 0.9});
  for (const auto& [a, b] :
       {std::pair(3.0, 1.5), std::pair(1.5, 3.0), std::pair(0.3, 0.3), std::pair(0.0, 0.0), std::pair(0.0, 5.0)}) {
    CHECK(update_circle(t, a, b) == update_along_edges(t, a, b));
  }
  for (const auto& [a, b] : {std::pair(3.0, 1.5), std::pair(1.5, 3.0), std::pair(0.0, 1.0)}) {
    CHECK(update_planar(t, a, b) == update_along_edges(t, a, b));
  }
}

TEST_CASE("a triangle without height is a line, and its update a finite real path") {
  test::Random random(4);
  for (int i = 0; i < kRounds; ++i) {
    const double base = random.real(0.1, 2), x = random.real(-1, 3);
    const UpdateTriangle t = make_update_triangle(base, std::abs(x), std::abs(x - base), 0);
    const Vec2 source(random.real(-2, 3), random.real(-2, 0));
    const double a = source.norm(), b = (source - Vec2(base, 0)).norm();
    const double straight = (source - Vec2(x, 0)).norm(), edges = update_along_edges(t, a, b);
    const double circle = update_circle(t, a, b), planar = update_planar(t, a, b);
    REQUIRE(std::isfinite(planar));
    REQUIRE(planar <= edges * (1 + 1e-12));
    REQUIRE(circle >= straight * (1 - 1e-7));
    REQUIRE(circle <= edges * (1 + 1e-12));
  }
}

TEST_CASE("no update is above that along the edges") {
  test::Random random(5);
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = random.real(0, 4), b = random.real(0, 4), edges = update_along_edges(t, a, b);
    REQUIRE(update_circle(t, a, b) <= edges * (1 + 1e-12));
    REQUIRE(update_planar(t, a, b) <= edges * (1 + 1e-12));
  }
}

TEST_CASE("no update is below the smaller distance, except that of circles at an obtuse corner D") {
  test::Random random(6);
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = random.real(0, 4), b = random.real(0, 4), least = std::min(a, b);
    REQUIRE(update_planar(t, a, b) >= least * (1 - 1e-12));
    const bool obtuse = t.side_a * t.side_a + t.side_b * t.side_b < t.base * t.base;
    REQUIRE(update_circle(t, a, b) >= (obtuse ? least - 0.5 * t.base : least * (1 - 1e-12)));
  }
  // The smallest case: the source is right behind the base, and D right before it.
  const UpdateTriangle flat = triangle_of(2, {1, 0.1});
  CHECK(update_circle(flat, std::hypot(1, 0.1), std::hypot(1, 0.1)) == Approx(0.2));
}

TEST_CASE("updates scale exactly with powers of two") {
  test::Random random(7);
  for (const double scale : {std::ldexp(1.0, -40), std::ldexp(1.0, 40)}) {
    for (int i = 0; i < 1000; ++i) {
      const Sample s = random_sample(random);
      const UpdateTriangle t = triangle_of(s.base, s.d), large = triangle_of(scale * s.base, scale * s.d);
      const double a = random.real(0, 4), b = random.real(0, 4);
      REQUIRE(update_circle(large, scale * a, scale * b) == scale * update_circle(t, a, b));
      REQUIRE(update_planar(large, scale * a, scale * b) == scale * update_planar(t, a, b));
    }
  }
}

}  // namespace gvd::test_local_update
