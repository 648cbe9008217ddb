#include <cmath>
#include <numbers>

#include "geodesic/tracing/polar_update.hpp"
#include "gvd/vec.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_polar_update {

constexpr double kPi = std::numbers::pi;

TEST_CASE("polar update: a triangle without area is passed along its edges or through its base, finitely") {
  const UpdateTriangle flat = make_update_triangle(2, 1, 1, 0);
  const PolarStep from_a = step_to_corner(flat, 0, 2);
  CHECK(from_a.distance == Approx(1));
  CHECK(polar_angle(flat, from_a, 0.5, 0.5) == Approx(0.5));
  CHECK(std::isfinite(step_to_corner(flat, 1, 1).distance));
}

TEST_CASE("polar update: a source at a corner of the base") {
  const UpdateTriangle t = make_update_triangle(1, 1, 1, std::sqrt(3.0) / 2);
  const PolarStep at_a = step_to_corner(t, 0, 1), at_b = step_to_corner(t, 1, 0);
  CHECK(at_a.distance == Approx(1));
  CHECK(at_b.distance == Approx(1));
}

TEST_CASE("polar update: exact for a planar source, and symmetric") {
  const Vec2 a(0, 0), b(2, 0), d(0.8, 1.5), source(0.5, -2);
  const UpdateTriangle t = make_update_triangle(2, d.norm(), (d - b).norm(), 2 * 1.5);
  const PolarStep step = step_to_corner(t, (a - source).norm(), (b - source).norm());
  CHECK(step.kind == PolarStep::Kind::through_base);
  CHECK(step.distance == Approx((d - source).norm()).epsilon(1e-14));
  const auto azimuth = [&](const Vec2& p) { return std::atan2(p.y() - source.y(), p.x() - source.x()); };
  CHECK(polar_angle(t, step, azimuth(a), azimuth(b)) == Approx(azimuth(d)).epsilon(1e-14));
  // Directions on both sides of pi.
  const double turn = kPi - azimuth(d);
  CHECK(polar_angle(t, step, azimuth(a) + turn, azimuth(b) + turn - 2 * kPi) ==
        Approx(azimuth(d) + turn).epsilon(1e-14));
  const UpdateTriangle mirrored = make_update_triangle(2, (d - b).norm(), d.norm(), 2 * 1.5);
  const PolarStep other = step_to_corner(mirrored, (b - source).norm(), (a - source).norm());
  CHECK(other.distance == Approx(step.distance).epsilon(1e-14));
  CHECK(polar_angle(mirrored, other, azimuth(b), azimuth(a)) == Approx(azimuth(d)).epsilon(1e-14));
}

TEST_CASE("polar update: along an edge where the source does not see the corner") {
  const UpdateTriangle t = make_update_triangle(1, 1, 1, std::sqrt(3.0) / 2);
  const PolarStep broken = step_to_corner(t, 0.1, 5);  // no triangle has these sides
  CHECK(broken.distance == Approx(1.1));
  CHECK(broken.kind == PolarStep::Kind::along_a);
  CHECK(polar_angle(t, broken, 0.25, 2) == 0.25);
  const PolarStep aside = step_to_corner(t, 3.9, 3);  // the source lies far beyond B
  CHECK(aside.distance == Approx(4));
  CHECK(aside.kind == PolarStep::Kind::along_b);
  CHECK(polar_angle(t, aside, 0.25, 2) == 2);
}

TEST_CASE("polar update: random sources that see the corner through the base are exact, others go along an edge") {
  test::Random random(11);
  int through = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Vec2 a(0, 0), b(1, 0), d(random.real(-0.5, 1.5), random.real(0.05, 2));
    const Vec2 source(random.real(-2, 3), random.real(-3, -0.01));
    const UpdateTriangle t = make_update_triangle(1, d.norm(), (d - b).norm(), d.y());
    const PolarStep step = step_to_corner(t, source.norm(), (source - b).norm());
    const double x = source.x() + (d.x() - source.x()) * -source.y() / (d.y() - source.y());
    if (std::min(std::abs(x), std::abs(x - 1)) < 1e-6) continue;
    CAPTURE(trial, x);
    if (x > 0 && x < 1) {
      ++through;
      CHECK(step.kind == PolarStep::Kind::through_base);
      CHECK(step.distance == Approx((d - source).norm()).epsilon(1e-9));
    } else {
      CHECK(step.kind != PolarStep::Kind::through_base);
      CHECK(step.distance == Approx(std::min(source.norm() + d.norm(), (source - b).norm() + (d - b).norm())));
    }
  }
  CHECK(through > 100);
}

}  // namespace gvd::test_polar_update
