#include <vector>

#include "geodesic/windows/propagation/waiting_windows.hpp"
#include "support/catch.hpp"

namespace gvd::test_waiting_windows {

using Heads = IdVector<HalfedgeId, std::int32_t>;
constexpr std::uint32_t kAtBegin = WindowHistory::kAtBegin, kAtEnd = WindowHistory::kAtEnd;

Window make_window(double begin, double end, HalfedgeId h = HalfedgeId(0)) {
  return {begin, end, 0.5, 1, 0, GeneratorId(0), h};
}

std::vector<PropagatedWindow> take_all(WaitingWindows& waiting, HalfedgeId h) {
  std::vector<PropagatedWindow> taken;
  waiting.take(h, [&](const PropagatedWindow& w) { taken.push_back(w); });
  return taken;
}

TEST_CASE("waiting windows take windows again after their memory was released") {
  Heads first(2, -1);
  WaitingWindows waiting(first, 1);
  for (int time = 0; time < 2; ++time) {
    for (std::int32_t i = 0; i < 1000; ++i) {
      waiting.add({0.25, 0.5, i / 1000.0, 1, 0, GeneratorId(i), HalfedgeId(i % 2)}, {0, 0, FaceId()}, 1, 1);
    }
    for (const HalfedgeId h : {HalfedgeId(0), HalfedgeId(1)}) {
      const std::vector<PropagatedWindow> taken = take_all(waiting, h);
      CHECK(taken.size() == 500);
      for (const PropagatedWindow& w : taken) {
        CHECK(w.window.x == w.window.generator.value() / 1000.0);
        CHECK(w.window.generator.value() % 2 == h.value());
        CHECK(w.window.halfedge == h);
      }
      CHECK(take_all(waiting, h).empty());
    }
    waiting.release();
  }
}

TEST_CASE("a waiting window keeps its history") {
  Heads first(1, -1);
  WaitingWindows waiting(first, 1);
  waiting.add(make_window(0, 1), {(1u << 30) - 1, kAtEnd, FaceId(12)}, 1, 1);
  const std::vector<PropagatedWindow> taken = take_all(waiting, HalfedgeId(0));
  REQUIRE(taken.size() == 1);
  CHECK(taken[0].history.crossed_faces == (1u << 30) - 1);
  CHECK(taken[0].history.joinable_ends == kAtEnd);
  CHECK(taken[0].history.cycle_check_face == FaceId(12));
}

TEST_CASE("a halfedge is queued for its first window, and again for a smaller key only") {
  Heads first(1, -1);
  WaitingWindows waiting(first, 0.25);
  const auto add = [&](double key) { return waiting.add(make_window(0, 1), {1, 0, FaceId()}, 1, key); };
  CHECK(add(4));
  CHECK_FALSE(add(5));
  CHECK_FALSE(add(3.9));  // smaller by less than the key step
  CHECK(add(3.5));
  CHECK_FALSE(add(3.5));
  CHECK(take_all(waiting, HalfedgeId(0)).size() == 5);
  CHECK(add(4));
}

TEST_CASE("two windows that a flat vertex has split are joined, and no others") {
  const auto joined_count = [](const Window& a, std::uint32_t ends_of_a, const Window& b, std::uint32_t ends_of_b) {
    Heads first(1, -1);
    WaitingWindows waiting(first, 1);
    waiting.add(a, {1, ends_of_a & 3u, FaceId(3)}, 1, 1);
    waiting.add(b, {1, ends_of_b & 3u, FaceId(3)}, 1, 1);
    return take_all(waiting, HalfedgeId(0)).size();
  };
  const Window left = make_window(0.25, 0.5), right = make_window(0.5, 0.75);
  CHECK(joined_count(left, kAtEnd, right, kAtBegin) == 1);
  CHECK(joined_count(right, kAtBegin, left, kAtEnd) == 1);
  CHECK(joined_count(left, kAtBegin, right, kAtEnd) == 2);
  CHECK(joined_count(left, 0, right, kAtBegin) == 2);
  CHECK(joined_count(left, kAtEnd, make_window(0.6, 0.75), kAtBegin) == 2);  // a gap
  Window other = right;
  other.generator = GeneratorId(1);
  CHECK(joined_count(left, kAtEnd, other, kAtBegin) == 2);
  other = right;
  other.offset = 0.1;
  CHECK(joined_count(left, kAtEnd, other, kAtBegin) == 2);
  other = right;
  other.depth = 1 + 1e-9;
  CHECK(joined_count(left, kAtEnd, other, kAtBegin) == 2);
}

TEST_CASE("a joined window knows only what holds for both of its parts") {
  Heads first(1, -1);
  WaitingWindows waiting(first, 1);
  waiting.add(make_window(0.25, 0.5), {9, kAtEnd, FaceId(3)}, 1, 1);
  waiting.add(make_window(0.5, 0.75), {4, kAtBegin | kAtEnd, FaceId(4)}, 1, 1);
  const std::vector<PropagatedWindow> taken = take_all(waiting, HalfedgeId(0));
  REQUIRE(taken.size() == 1);
  CHECK(taken[0].window.begin == 0.25);
  CHECK(taken[0].window.end == 0.75);
  CHECK(taken[0].history.joinable_ends == kAtEnd);
  CHECK(taken[0].history.crossed_faces == 4);
  CHECK_FALSE(taken[0].history.cycle_check_face.valid());
}

TEST_CASE("thin windows that join make one that holds both, in whatever order they come") {
  for (const bool swapped : {false, true}) {
    // Narrower than what ends may differ by, and given as if the left one were the right one.
    const Window left = make_window(0.5, 0.5 + 1e-11), right = make_window(0.5 + 1e-11, 0.5 + 2e-11);
    Heads first(1, -1);
    WaitingWindows waiting(first, 1);
    waiting.add(swapped ? right : left, {1, kAtEnd, FaceId(3)}, 1, 1);
    waiting.add(swapped ? left : right, {1, kAtBegin, FaceId(4)}, 1, 1);
    const std::vector<PropagatedWindow> taken = take_all(waiting, HalfedgeId(0));
    REQUIRE(taken.size() == 1);
    CHECK(taken[0].window.begin == left.begin);
    CHECK(taken[0].window.end == right.end);
    CHECK_FALSE(taken[0].history.cycle_check_face.valid());  // only some of the paths have crossed it
  }
}

}  // namespace gvd::test_waiting_windows
