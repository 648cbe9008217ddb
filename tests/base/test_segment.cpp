#include <cmath>

#include "base/segment.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_segment {

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

}  // namespace gvd::test_segment
