#include <cmath>
#include <limits>

#include "base/plane.hpp"
#include "diagram/envelope/bisector_sampler.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/random.hpp"

namespace gvd::test_bisector_sampler {

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

SearchBand band_between(const Vec2& from, const Vec2& to, double width) {
  const Vec2 along = (to - from).normalized();
  return {from, along, turned_left(along), (to - from).norm(), width};
}

bool sees(const FaceSource& s, const Vec2& p) { return s.shortest_path(p).from == s.image; }

TEST_CASE("a band contains its chord, and what is as near as its width, also beyond the ends") {
  const SearchBand band = band_between({1, 1}, {3, 1}, 0.25);
  CHECK(band.contains({1, 1}));
  CHECK(band.contains({3.25, 1.25}));
  CHECK_FALSE(band.contains({3.26, 1}));
  CHECK_FALSE(band.contains({2, 1.26}));
  CHECK(band.position({2.5, 1.1}) == Approx(1.5));
  CHECK_FALSE(band.is_all());
  CHECK(band_between({1, 1}, {3, 1}, kInfinity).is_all());
}

TEST_CASE("without sources nothing is visible, and the nearest path is infinite") {
  std::vector<VisibleSource> visible(3);
  collect_visible_sources({}, band_between({0, 1}, {1, 1}, 0.1), visible);
  CHECK(visible.empty());
  CHECK(std::isinf(nearest_visible(visible, 0, {0, 1}).path.distance));
}

TEST_CASE("corners are visible from everywhere, and every source where the band is the whole plane") {
  const std::vector<FaceSource> sources{test::from_corner(0, 0, {0, 0}, 1),
                                        test::through_side(0, 0, {5, -1}, {{5, 0}, {5.1, 0}}, 0)};
  std::vector<VisibleSource> visible;
  collect_visible_sources(sources, band_between({0, 1}, {1, 1}, 0.01), visible);
  REQUIRE(visible.size() == 1);
  CHECK(visible[0].source == &sources[0]);
  CHECK(visible[0].first == -kInfinity);
  CHECK(visible[0].last == kInfinity);
  collect_visible_sources(sources, band_between({0, 1}, {1, 1}, kInfinity), visible);
  CHECK(visible.size() == 2);
}

TEST_CASE("every source that sees a point of a random band is visible at its position") {
  test::Random random(3);
  int seen = 0, passed_over = 0;
  for (int round = 0; round < 2000; ++round) {
    const double begin = random.real(0, 2), end = begin + random.real(0.01, 1);
    const Vec2 image(random.real(-1, 3), random.real(-2, -0.1));
    const std::vector<FaceSource> sources{test::through_side(0, 0, image, {{begin, 0}, {end, 0}}, 0)};
    const Vec2 from(random.real(0, 2), random.real(0.1, 2)), to(random.real(0, 2), random.real(0.1, 2));
    const SearchBand band = band_between(from, to, 0.05 * (to - from).norm());
    std::vector<VisibleSource> visible;
    collect_visible_sources(sources, band, visible);
    for (int k = 0; k < 30; ++k) {
      const Vec2 p = from + random.real(-0.05, 1.05) * (to - from) + random.real(-1, 1) * band.width * band.across;
      if (!sees(sources[0], p)) {
        passed_over += visible.empty();
        continue;
      }
      ++seen;
      INFO("round " << round);
      REQUIRE(visible.size() == 1);
      REQUIRE(nearest_visible(visible, band.position(p), p).path.distance == sources[0].distance(p));
    }
  }
  CHECK(seen > 1000);
  CHECK(passed_over > 1000);
}

const PlaneSegment kSegment{{0, 0}, {1, 0}};

/// A source that sees all points from its image.
FaceSource seeing_all(const Vec2& image, double offset) {
  return {image, image, image, offset, GeneratorId(0), HalfedgeId(0), true, offset, offset};
}

PathChange change_between(const FaceSource& first, const FaceSource& second) {
  return PathChange(kSegment, first, first.distance(kSegment.from), second, second.distance(kSegment.to));
}

TEST_CASE("two sources on the segment's line: the corner is in the middle, and as high as the lines make it") {
  const FaceSource first = seeing_all({-1, 0}, 0), second = seeing_all({2, 0}, 0);
  PathChange change = change_between(first, second);
  // The distance rises from 1 to 1.5 and falls to 1 again.
  CHECK(change.height() == 0.5);
  CHECK(change.find(1e-9) == 0.5);
}

TEST_CASE("no corner without a change, nor where the sources tie at an end") {
  CHECK(PathChange().height() == 0);
  const FaceSource first = seeing_all({-1, 0}, 0), second = seeing_all({2, 0}, 1);  // tie at the end
  CHECK(change_between(first, second).height() == 0);
}

TEST_CASE("the height is that of the corner above the chord where distances are nearly linear") {
  const FaceSource first = seeing_all({-1000, 0}, 0), second = seeing_all({1001, 10}, 0.25);
  PathChange change = change_between(first, second);
  const double t = change.find(1e-12);
  const double corner = first.distance({t, 0}), chord = (1 - t) * first.distance({0, 0}) + t * second.distance({1, 0});
  CHECK(std::abs(change_between(first, second).height() - (corner - chord)) < 1e-4 * (corner - chord));
}

TEST_CASE("near curved distances, both sources are equally far at the position found") {
  test::Random random(1);
  int found = 0;
  for (int round = 0; round < 1000; ++round) {
    const FaceSource first = seeing_all({random.real(-1, 0.3), random.real(0.1, 1)}, random.real(0, 0.2));
    const FaceSource second = seeing_all({random.real(0.7, 2), random.real(-1, -0.1)}, random.real(0, 0.2));
    if (!(first.distance({0, 0}) < second.distance({0, 0}) && second.distance({1, 0}) < first.distance({1, 0})))
      continue;
    const double t = change_between(first, second).find(1e-10);
    const Vec2 p(t, 0);
    REQUIRE((t > 0 && t < 1));
    REQUIRE(std::abs(first.distance(p) - second.distance(p)) < 1e-5);  // eight steps
    ++found;
  }
  CHECK(found > 500);
}

}  // namespace gvd::test_bisector_sampler
