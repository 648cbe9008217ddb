// Each rule that drops windows: what it drops is beaten, and what it must keep stays.
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "geodesic/windows/propagate_windows.hpp"
#include "geodesic/windows/waiting_windows.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "mesh/working_mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/propagate.hpp"
#include "support/tiny_meshes.hpp"

using namespace gvd;

TEST_CASE("what a filter drops is beaten at every point of the interval") {
  std::mt19937 random(5);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
  int beaten = 0;
  for (int run = 0; run < 20000; ++run) {
    const double length = 0.1 + unit(), begin = unit() * length, end = begin + unit() * (length - begin);
    const Rays w{begin, end, 4 * unit() - 2, 0.001 + unit()};
    const double offset = unit(), start_distance = 2 * unit(), end_distance = 2 * unit();
    const bool by_start = is_beaten_by_start(w, offset, start_distance);
    const bool by_end = is_beaten_by_end(w, offset, end_distance, length);
    beaten += by_start || by_end;
    for (int i = 0; i <= 4; ++i) {
      const double t = begin + i * (end - begin) / 4;
      if (by_start) REQUIRE(start_distance + t < offset + w.reach(t));
      if (by_end) REQUIRE(end_distance + length - t < offset + w.reach(t));
    }
  }
  CHECK(beaten > 2000);
}

TEST_CASE("equal paths do not drop each other") {
  const Rays w{0.25, 1, -0.5, 1e-9};
  CHECK_FALSE(is_beaten_by_start(w, 0.5, 1));
  CHECK_FALSE(is_beaten_by_start(w, 0.5, 1 - 1e-15));  // shorter by rounding
  CHECK(is_beaten_by_start(w, 0.5, 1 - 1e-9));
}

TEST_CASE("a path is news where it is shorter by more than rounding") {
  CHECK(is_shorter_beyond_rounding(1 - 1e-14, 1));
  CHECK_FALSE(is_shorter_beyond_rounding(1 - 2e-16, 1));
  CHECK(is_shorter_beyond_rounding(1, std::numeric_limits<double>::infinity()));
}

TEST_CASE("a window is left to a vertex where the two tie, and not where the window is shorter") {
  CHECK(is_left_to_vertex(1, 2, 0.5, 1.5 * 1.5));
  CHECK(is_left_to_vertex(1, 2, 0.5, 1.6 * 1.6));
  CHECK_FALSE(is_left_to_vertex(1, 2, 0.5 + 1e-13, 1.5 * 1.5));
}

TEST_CASE("paths that meet a face again are told by their cycle_check_face, or by their number") {
  Origin origin{0, 0, 1, 7, 0};
  CHECK(is_crossed_twice(origin, 7, 100));
  CHECK_FALSE(is_crossed_twice(origin, 8, 100));
  origin.crossed = 100;
  CHECK(is_crossed_twice(origin, 8, 100));
  // Round a cycle of any length, after any way to it: the cycle_check_face is met again before three times both are
  // over.
  for (int cycle = 1; cycle < 40; ++cycle) {
    for (int before = 0; before < 40; ++before) {
      Origin way{0, 0, 1, 0, 0};
      int step = 1;
      const auto face_at = [&](int i) { return i < before ? i : before + (i - before) % cycle; };
      for (; !is_crossed_twice(way, face_at(step), 1000000); ++step) {
        if (is_cycle_check_step(++way.crossed)) way.cycle_check_face = face_at(step);
        REQUIRE(step < 4 * (cycle + before) + 4);
      }
      CHECK(step >= cycle);
    }
  }
}

TEST_CASE("one window of those that cover an apex goes on to both sides") {
  ApexPath path;
  const auto exits = [&](double distance, double crossing) {
    const Exits found = exits_beside(path, {distance, crossing}, 1e-12);
    return std::array{found.left, found.right};
  };
  CHECK(exits(2, 0.5) == std::array{true, true});
  CHECK(exits(3, 0.4) == std::array{true, false});
  CHECK(exits(2, 0.6) == std::array{false, true});
  CHECK(exits(2, 0.5) == std::array{true, true});  // the same ray again
  CHECK(exits(1, 0.6) == std::array{true, true});  // a better one
  CHECK(exits(2, 0.5) == std::array{true, false});
}

TEST_CASE("what one angle, one split drops is beaten by the path that it is dropped for") {
  std::mt19937 random(8);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
  int dropped = 0;
  for (int run = 0; run < 20000; ++run) {
    // The edge from (0, 0) to (1, 0), the apex above, and two images below that see all of the edge.
    const double ax = unit(), ay = 0.1 + unit();
    const double x1 = unit(), y1 = 0.1 + unit(), x2 = unit(), y2 = 0.1 + unit();
    const double d1 = std::hypot(ax - x1, ay + y1), d2 = std::hypot(ax - x2, ay + y2);
    const double offset = std::max(0.0, d2 - d1) * unit();
    const auto crossing = [&](double x, double y) { return x + (ax - x) * y / (y + ay); };
    ApexPath path{offset + d1, crossing(x1, y1)};
    if (!(offset + d1 <= d2)) continue;
    const Exits exits = exits_beside(path, {d2, crossing(x2, y2)}, 1e-12);
    for (int i = 0; i <= 8; ++i) {
      const double t = i / 8.0;
      if (!exits.right) {
        const double px = ax + t * (1 - ax), py = ay * (1 - t), at = x2 + (px - x2) * y2 / (y2 + py);
        // Rays on the far side of the other path's may come from behind its image: then that lies in this window.
        if (at <= path.crossing) REQUIRE(offset + std::hypot(px - x1, py + y1) <= std::hypot(px - x2, py + y2) + 1e-12);
      }
    }
    dropped += !exits.left + !exits.right;
  }
  CHECK(dropped > 5000);
}

TEST_CASE("paths to a vertex come in the order of length and generator, and rounding decides no tie") {
  const double inf = std::numeric_limits<double>::infinity();
  constexpr double kRounded = 1e-14, kShorter = 1e-13;
  CHECK(is_before(1, 5, inf, -1));
  CHECK(is_before(1, 5, inf, 3));  // a label for the time being
  CHECK(is_before(1 - kShorter, 5, 1, 3));
  CHECK_FALSE(is_before(1 - kRounded, 5, 1, 3));
  CHECK(is_before(1 + kRounded, 3, 1, 5));
  CHECK_FALSE(is_before(1 + kShorter, 3, 1, 5));
  CHECK(is_before(1 - kRounded, 3, 1, 3));
  CHECK_FALSE(is_before(1, 3, 1, 3));
  CHECK_FALSE(is_before(1 + kRounded, 3, 1, 3));
  CHECK_FALSE(is_before(inf, 3, inf, 5));
}
