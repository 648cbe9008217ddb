#include <cmath>

#include "geodesic/windows/window_geometry.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_window_geometry {

Window make_window(double begin, double end, double x, double depth) {
  return {begin, end, x, depth, 0, GeneratorId(0), HalfedgeId(0)};
}

TEST_CASE("an apex between two windows that rounding has parted is grazed") {
  // The image is 1e-8 of the edge away from it, where 1e-16 of the edge is an angle of 1e-8.
  const Window w = make_window(0.25, 1, 0.25, 1e-8);
  const ApexView apex(w, 0.25 - 1e-15, 1e-8);
  REQUIRE(apex.all_right());
  CHECK(is_grazed(w, apex, 1));
  CHECK_FALSE(is_grazed(w, apex, 1e-3));
  const ApexView behind(w, 0.25 - 1e-15, -0.5e-8);
  CHECK_FALSE(is_grazed(w, behind, 1));
}

TEST_CASE("an apex that a window misses by its drift lies in a gap where the path is no longer") {
  const Window w = make_window(2e-11, 0.25, 0, 1);
  const ApexView apex(w, 0, 1e-6);
  CHECK_FALSE(is_grazed(w, apex, 0.25));
  CHECK_FALSE(is_in_gap(w, apex, 1e-11));
  CHECK(is_in_gap(w, apex, 1e-10));
  // 2e-7 across at a distance of 1e-6 makes the path longer by 2e-8 of itself.
  const Window aside = make_window(2e-7, 0.25, 0, 1);
  CHECK_FALSE(is_in_gap(aside, ApexView(aside, 0, 1e-6), 1e-6));
}

TEST_CASE("a window that crosses a face keeps the distances to the points that it reaches") {
  test::Random random(3);
  int left_count = 0, right_count = 0;
  for (int run = 0; run < 2000; ++run) {
    const Vec3 tip(random.real(-0.5, 1.5), random.real(0.1, 1), 0);
    const Mesh mesh = test::make_mesh({{0, 0, 0}, {1, 0, 0}, tip}, {{0, 1, 2}});
    const FaceFrame f = make_face_frame(mesh, FaceId(0));
    const double begin = random.real(0, 0.9);
    const Window w = make_window(begin, random.real(begin, 1), random.real(-1, 2), random.real(0.1, 2));
    const ApexView apex(w, tip.x(), tip.y());
    CAPTURE(run, w.begin, w.end, w.x, w.depth, tip.x(), tip.y());
    // The point t of a side, counted as the next face counts, in the frame of the window's edge.
    const auto check = [&](const Window& next, const Vec3& origin, const Vec3& target) {
      REQUIRE(next.begin <= next.end + 1e-12);
      for (const double fraction : {0.0, 0.3, 1.0}) {
        const double t = next.begin + fraction * (next.end - next.begin);
        const Vec3 p = origin + t * (target - origin).normalized();
        const double crossing = w.x + (p.x() - w.x) * w.depth / (w.depth + p.y());
        CHECK(next.distance(t) == Approx(std::hypot(p.x() - w.x, p.y() + w.depth)).epsilon(1e-10));
        CHECK(crossing >= w.begin - 1e-9);
        CHECK(crossing <= w.end + 1e-9);
      }
    };
    if (!apex.all_right()) {
      check(cross_left(w, left_exit(f, 0), apex), {0, 0, 0}, tip);
      ++left_count;
    }
    if (!apex.all_left()) {
      check(cross_right(w, f.length[0], right_exit(f, 0), apex), tip, {1, 0, 0});
      ++right_count;
    }
    if (apex.covered()) {
      CHECK(cross_left(w, left_exit(f, 0), apex).end == f.length[2]);
      CHECK(cross_right(w, f.length[0], right_exit(f, 0), apex).begin == 0);
      CHECK(apex.squared_image_distance(w) ==
            Approx((tip.x() - w.x) * (tip.x() - w.x) + (tip.y() + w.depth) * (tip.y() + w.depth)));
    }
  }
  CHECK(left_count > 400);
  CHECK(right_count > 400);
}

}  // namespace gvd::test_window_geometry
