#include <queue>

#include "base/polygon_ring.hpp"
#include "support/catch.hpp"

namespace gvd::test_polygon_ring {

TEST_CASE("polygon ring: at first every corner is left, between its neighbours") {
  const PolygonRing ring(4);
  CHECK(ring.corner_count() == 4);
  CHECK(ring.left_count() == 4);
  CHECK(ring.first_left() == 0);
  CHECK(ring.triangle(0) == std::array<std::size_t, 3>{3, 0, 1});
  CHECK(ring.triangle(3) == std::array<std::size_t, 3>{2, 3, 0});
}

TEST_CASE("polygon ring: a removed corner links its neighbours and makes their triangles new") {
  PolygonRing ring(5);
  ring.remove(0);
  CHECK_FALSE(ring.is_left(0));
  CHECK(ring.first_left() == 1);
  CHECK(ring.left_count() == 4);
  CHECK(ring.after(4) == 1);
  CHECK(ring.before(1) == 4);
  CHECK(ring.version(1) == 1);
  CHECK(ring.version(4) == 1);
  CHECK(ring.version(2) == 0);
  ring.remove(1);
  CHECK(ring.triangle(2) == std::array<std::size_t, 3>{4, 2, 3});
  CHECK(ring.version(4) == 2);
}

TEST_CASE("polygon ring: a candidate is outdated once its corner or a neighbour is gone") {
  PolygonRing ring(5);
  const EarCandidate at_1 = ring.candidate(1, 0.5), at_2 = ring.candidate(2, 0.5), at_4 = ring.candidate(4, 0.5);
  CHECK(ring.is_current(at_1));
  ring.remove(1);
  CHECK_FALSE(ring.is_current(at_1));
  CHECK_FALSE(ring.is_current(at_2));
  CHECK(ring.is_current(at_4));
  CHECK(ring.is_current(ring.candidate(2, 0.5)));
}

TEST_CASE("ear candidates: the best quality comes first, of equal ones the first corner") {
  std::priority_queue<EarCandidate> queue;
  for (const EarCandidate& ear : {EarCandidate{0.5, 3, 0}, {0.7, 4, 0}, {0.5, 1, 0}, {-2, 0, 0}}) queue.push(ear);
  for (const std::size_t expected : {4, 1, 3, 0}) {
    CHECK(queue.top().corner == expected);
    queue.pop();
  }
}

}  // namespace gvd::test_polygon_ring
