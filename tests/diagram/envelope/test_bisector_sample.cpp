#include <cmath>
#include <limits>

#include "diagram/envelope/bisector_sample.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_bisector_sample {

/// What two images with offsets give at p.
BisectorSample sample(const Vec2& p, const Vec2& left, double left_offset, const Vec2& right, double right_offset) {
  return {p, {left_offset + (p - left).norm(), left}, {right_offset + (p - right).norm(), right}};
}

TEST_CASE("a generator without a path makes a sample unknown") {
  BisectorSample s = sample({0, 0}, {-1, 0}, 0, {1, 0}, 0);
  CHECK(s.is_known());
  s.right.distance = std::numeric_limits<double>::infinity();
  CHECK_FALSE(s.is_known());
}

TEST_CASE("at an image the direction is zero, and nothing else fails") {
  const BisectorSample s = sample({-1, 0}, {-1, 0}, 0, {1, 0}, 0);
  CHECK(s.gradient() == Vec2(1, 0));
  CHECK(s.error() == -2);
}

TEST_CASE("halfway between two images: no error, and the bisector has the left one on its left") {
  const BisectorSample s = sample({0, 0.5}, {-1, 0.5}, 0.25, {1, 0.5}, 0.25);
  CHECK(s.error() == 0);
  CHECK(s.gradient() == Vec2(2, 0));
  CHECK(s.tangent() == Vec2(0, 2));
  CHECK(s.distance_to_bisector({-1, 0}, 1e-12) == 0);
}

TEST_CASE("the distance to the bisector leads to a point that is equally far from both images") {
  test::Random random(1);
  int found = 0;
  for (int round = 0; round < 1000; ++round) {
    const Vec2 left(-random.real(0.5, 2), random.real(-1, 1)), right(random.real(0.5, 2), random.real(-1, 1));
    const double offset = random.real(-0.2, 0.2);
    const Vec2 p(random.real(-0.1, 0.1), random.real(-0.5, 0.5)), across(-1, 0);
    const BisectorSample at_p = sample(p, left, offset, right, 0);
    const Vec2 q = p + at_p.distance_to_bisector(across, 1e-14) * across;
    const BisectorSample at_q = sample(q, left, offset, right, 0);
    REQUIRE(std::abs(at_q.error()) < 1e-7);  // four of Newton's steps
    REQUIRE(std::abs(at_q.error()) <= std::abs(at_p.error()) + 1e-15);
    ++found;
  }
  CHECK(found == 1000);
}

TEST_CASE("the rounding bound covers sums of two terms") {
  test::Random random(2);
  for (int round = 0; round < 1000; ++round) {
    const Vec2 p(random.real(-1, 1), random.real(-1, 1)), image(random.real(2, 9), random.real(-1, 1));
    // The same distance, its offset added in two ways.
    const double offset = random.real(0, 5);
    const BisectorSample s{p, {offset + (p - image).norm(), image}, {(offset + 1) + ((p - image).norm() - 1), image}};
    REQUIRE(std::abs(s.error()) <= 8 * s.rounding());
  }
}

}  // namespace gvd::test_bisector_sample
