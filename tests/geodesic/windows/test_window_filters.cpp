// Each rule that drops windows: what it drops is beaten by a shorter path, and other windows stay.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "geodesic/windows/propagation/face_crossing.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "support/catch.hpp"

namespace gvd::test_window_filters {

Window make_window(double begin, double end, double x, double depth, double offset = 0) {
  return {begin, end, x, depth, offset, GeneratorId(0), HalfedgeId(0)};
}

TEST_CASE("a path counts as shorter only beyond rounding") {
  CHECK(is_shorter_beyond_rounding(1 - 1e-14, 1));
  CHECK_FALSE(is_shorter_beyond_rounding(1 - 2e-16, 1));
  CHECK(is_shorter_beyond_rounding(1, std::numeric_limits<double>::infinity()));
}

TEST_CASE("a window that a filter drops is beaten at every point of the interval") {
  std::mt19937 random(5);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
  int beaten = 0;
  for (int run = 0; run < 20000; ++run) {
    const double length = 0.1 + unit(), begin = unit() * length, end = begin + unit() * (length - begin);
    const Window w = make_window(begin, end, 4 * unit() - 2, 0.001 + unit(), unit());
    const double start_distance = 2 * unit(), end_distance = 2 * unit();
    const bool by_start = is_beaten_by_start(w, start_distance);
    const bool by_end = is_beaten_by_end(w, end_distance, length);
    beaten += by_start || by_end;
    for (int i = 0; i <= 4; ++i) {
      const double t = begin + i * (end - begin) / 4;
      if (by_start) REQUIRE(start_distance + t < w.distance(t));
      if (by_end) REQUIRE(end_distance + length - t < w.distance(t));
    }
  }
  CHECK(beaten > 2000);
}

TEST_CASE("equal paths do not drop each other") {
  const Window w = make_window(0.25, 1, -0.5, 1e-9, 0.5);
  CHECK_FALSE(is_beaten_by_start(w, 1));
  CHECK_FALSE(is_beaten_by_start(w, 1 - 1e-15));  // shorter by rounding
  CHECK(is_beaten_by_start(w, 1 - 1e-9));
}

TEST_CASE("a window without a width, or with its image on the edge, is empty") {
  CHECK_FALSE(is_empty(make_window(0.25, 0.5, 0, 1)));
  CHECK(is_empty(make_window(0.5, 0.5, 0, 1)));
  CHECK(is_empty(make_window(0.5, 0.25, 0, 1)));
  CHECK(is_empty(make_window(0.25, 0.5, 0, 0)));
}

TEST_CASE("a window is left to a vertex where the two tie, and not where the window is shorter") {
  CHECK(is_left_to_vertex(1, 2, 0.5, 1.5 * 1.5));
  CHECK(is_left_to_vertex(1, 2, 0.5, 1.6 * 1.6));
  CHECK_FALSE(is_left_to_vertex(1, 2, 0.5 + 1e-13, 1.5 * 1.5));
}

TEST_CASE("paths that enter a face twice are found by their cycle check face, or by their number of faces") {
  WindowHistory history{1, 0, FaceId(7)};
  CHECK(enters_face_twice(history, FaceId(7), 100));
  CHECK_FALSE(enters_face_twice(history, FaceId(8), 100));
  history.crossed_faces = 100;
  CHECK(enters_face_twice(history, FaceId(8), 100));
  // Round a cycle of any length, after any path to it: the face is entered again before three times both are over.
  for (int cycle = 1; cycle < 40; ++cycle) {
    for (int before = 0; before < 40; ++before) {
      WindowHistory path{1, 0, FaceId(0)};
      int step = 1;
      const auto face_at = [&](int i) { return FaceId(i < before ? i : before + (i - before) % cycle); };
      for (; !enters_face_twice(path, face_at(step), 1000000); ++step) {
        if (is_cycle_check_step(++path.crossed_faces)) path.cycle_check_face = face_at(step);
        REQUIRE(step < 4 * (cycle + before) + 4);
      }
      CHECK(step >= cycle);
    }
  }
}

TEST_CASE("of the windows that cover an apex, one continues to both sides") {
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

/// Points of the left side of the triangle, from the apex to the edge's start, or of the right side, to its end, are
/// nearer to the first image, with its offset, than to the second one. `path`: the offset, and where the path of the
/// first image crosses the edge.
void require_beaten(const Vec2& apex, const Vec2& first, const Vec2& second, const ApexPath& path, bool left) {
  const double ax = apex.x();
  for (int i = 0; i <= 8; ++i) {
    const double t = i / 8.0, py = apex.y() * (1 - t);
    const double px = left ? ax * (1 - t) : ax + t * (1 - ax);
    const double at = second.x() + (px - second.x()) * second.y() / (second.y() + py);
    // The proof holds for rays on this side of the other path's crossing; rays beyond it may pass its image.
    if (left ? at < path.crossing : at > path.crossing) continue;
    REQUIRE(path.distance + std::hypot(px - first.x(), py + first.y()) <=
            std::hypot(px - second.x(), py + second.y()) + 1e-12);
  }
}

TEST_CASE("what one angle, one split drops is beaten by the path that it is dropped for") {
  std::mt19937 random(8);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
  int dropped_left = 0, dropped_right = 0;
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
    REQUIRE((exits.left || exits.right));
    for (const bool left : {true, false}) {
      if (!(left ? exits.left : exits.right))
        require_beaten({ax, ay}, {x1, y1}, {x2, y2}, {offset, path.crossing}, left);
    }
    dropped_left += !exits.left;
    dropped_right += !exits.right;
  }
  CHECK(dropped_left > 2000);
  CHECK(dropped_right > 2000);
}

TEST_CASE("paths to a vertex come in the order of length and generator, and rounding decides no tie") {
  const double inf = std::numeric_limits<double>::infinity();
  constexpr double kRounded = 1e-14, kShorter = 1e-13;
  const auto before = [](double d, int generator, double known, int label) {
    return is_before(d, GeneratorId(generator), known, GeneratorId(label));
  };
  CHECK(before(1, 5, inf, -1));
  CHECK(before(1, 5, inf, 3));  // a provisional label
  CHECK(before(1 - kShorter, 5, 1, 3));
  CHECK_FALSE(before(1 - kRounded, 5, 1, 3));
  CHECK(before(1 + kRounded, 3, 1, 5));
  CHECK_FALSE(before(1 + kShorter, 3, 1, 5));
  CHECK(before(1 - kRounded, 3, 1, 3));
  CHECK_FALSE(before(1, 3, 1, 3));
  CHECK_FALSE(before(1 + kRounded, 3, 1, 3));
  CHECK_FALSE(before(inf, 3, inf, 5));
}

TEST_CASE("any path improves a vertex that has none, and only a better one a vertex that has") {
  DistanceLabels labels(2);
  const VertexCopyId v(1);
  CHECK(labels.is_improved_by(v, 7, GeneratorId(3)));
  labels.distance[v] = 7;
  labels.label[v] = GeneratorId(3);
  CHECK_FALSE(labels.is_improved_by(v, 7, GeneratorId(3)));
  CHECK(labels.is_improved_by(v, 7, GeneratorId(2)));
  CHECK(labels.is_improved_by(v, 6, GeneratorId(4)));
  CHECK(std::isinf(labels.distance[VertexCopyId(0)]));
}

TEST_CASE("a vertex without a label takes one provisionally") {
  DistanceLabels labels(1);
  const VertexCopyId v(0);
  CHECK_FALSE(labels.has_other_label(v, GeneratorId(3)));
  CHECK(labels.has_other_label(v, GeneratorId(4)));
  CHECK_FALSE(labels.has_other_label(v, GeneratorId(3)));
  CHECK(labels.is_improved_by(v, 1e9, GeneratorId(5)));
}

}  // namespace gvd::test_window_filters
