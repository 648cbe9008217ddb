#include "base/barycentric.hpp"
#include "pieces/clip_polygon.hpp"
#include "support/catch.hpp"

namespace gvd::test_clip_polygon {

using namespace paper;

TEST_CASE("a line cuts a face into two parts that share its ends") {
  const LinearForm form{1, -1, -3};
  const Polygon here = clip_polygon(whole_face(), form, true);
  const Polygon there = clip_polygon(whole_face(), {-1, 1, 3}, false);
  REQUIRE(here.size() == 3);
  REQUIRE(there.size() == 4);
  CHECK(area_share(here) == Approx(0.125));
  CHECK(area_share(here) + area_share(there) == Approx(1));
  CHECK(here[1] == Bary{0.5, 0.5, 0});
  CHECK(here[2][2] == 0.25);
  CHECK(here[2][1] == 0);
}

TEST_CASE("a polygon on one side of a line stays whole or vanishes") {
  CHECK(clip_polygon(whole_face(), {1, 2, 3}, false).size() == 3);
  CHECK(clip_polygon(whole_face(), {-1, -2, -3}, true).empty());
  CHECK(clip_polygon(whole_face(), {0, 0, 1}, false).size() == 3);
  CHECK(clip_polygon(whole_face(), {0, 0, -1}, true).empty());
}

TEST_CASE("only one of two generators has a face that is equally near to both") {
  CHECK(clip_polygon(whole_face(), {0, 0, 0}, true).size() == 3);
  CHECK(clip_polygon(whole_face(), {0, 0, 0}, false).empty());
}

TEST_CASE("a line through a corner cuts no sliver off by rounding") {
  const Polygon part = clip_polygon(whole_face(), {1e-16, 1, -1}, false);
  REQUIRE(part.size() == 3);
  CHECK(area_share(part) == Approx(0.5));
}

}  // namespace gvd::test_clip_polygon
