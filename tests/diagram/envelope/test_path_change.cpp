#include <cmath>

#include "diagram/envelope/path_change.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_path_change {

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

}  // namespace gvd::test_path_change
