// The nearest of some sources: as a search of all of them finds it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "geodesic/nearest_source.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_nearest_source {

/// An image below the x axis that sees the points above it through the opening from `begin` to `end` on it.
FaceSource window(const Vec2& image, double begin, double end, double offset, GeneratorId g) {
  const Vec2 left(begin, 0), right(end, 0);
  const double to_left = offset + (left - image).norm(), to_right = offset + (right - image).norm();
  return {image, left, right, offset, g, HalfedgeId(0), FaceSource::Kind::window, to_left, to_right};
}

TEST_CASE("nearest source: none of none, and the only one of one") {
  const Vec2 p(0.5, 1);
  const NearestSource none = nearest({}, p);
  CHECK(none.source == nullptr);
  CHECK(std::isinf(none.path.distance));
  const std::vector<FaceSource> one{window({0.5, -1}, 0, 1, 2, GeneratorId(0))};
  const NearestSource only = nearest(one, p);
  CHECK(only.source == one.data());
  CHECK(only.path.distance == 4);
  CHECK(only.path.from == one[0].image);
}

TEST_CASE("nearest source: of two at one distance the first, or that of the lower generator") {
  const std::vector<FaceSource> two{window({0.25, -1}, 0, 1, 0, GeneratorId(3)),
                                    window({0.75, -1}, 0, 1, 0, GeneratorId(2))};
  const Vec2 between(0.5, 1);
  CHECK(nearest(two, between).source == two.data());
  double distance = 0;
  CHECK(nearest_source(two, between, distance) == &two[1]);
  CHECK(distance == nearest(two, between).path.distance);
}

TEST_CASE("nearest source: the least distance of all, to the last bit") {
  test::Random random(3);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<FaceSource> sources;
    for (int i = 0; i < 1 + trial % 9; ++i) {
      const double begin = random.real(0, 0.5), end = begin + random.real(0.1, 0.5);
      const Vec2 image(random.real(-1, 2), -random.real(0.1, 2));
      sources.push_back(window(image, begin, end, random.real(0, 1), GeneratorId(i)));
    }
    const Vec2 p(random.real(0, 1), random.real(0.1, 1));
    const auto distance = [&](const FaceSource& s) { return s.distance(p); };
    CHECK(nearest(sources, p).path.distance == distance(*std::ranges::min_element(sources, {}, distance)));
  }
}

}  // namespace gvd::test_nearest_source
