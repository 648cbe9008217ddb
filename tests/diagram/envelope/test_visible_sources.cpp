#include <cmath>

#include "base/plane.hpp"
#include "diagram/envelope/visible_sources.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/random.hpp"

namespace gvd::test_visible_sources {

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

}  // namespace gvd::test_visible_sources
