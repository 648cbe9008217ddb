#include <vector>

#include "geodesic/windows/window_field.hpp"
#include "support/catch.hpp"

namespace gvd::test_window_field {

Window on(int halfedge, int generator) { return {0, 1, 0, 1, 0, GeneratorId(generator), HalfedgeId(halfedge)}; }

std::vector<int> generators_on(const EdgeWindows& windows, HalfedgeId h) {
  std::vector<int> found;
  windows.for_each(h, [&](const Window& w) { found.push_back(w.generator.value()); });
  return found;
}

TEST_CASE("windows of several lists are found by face and by halfedge, in their order") {
  const Progress silent;
  std::vector<KeptWindows> lists(2);
  for (const Window& w : {on(4, 0), on(3, 1), on(4, 2)}) lists[0].windows.push_back(w);
  for (const Window& w : {on(8, 3), on(0, 4)}) lists[1].windows.push_back(w);
  const EdgeWindows windows(std::move(lists), 4, ParallelChunks(1, silent));
  CHECK(windows.size() == 5);
  CHECK(generators_on(windows, HalfedgeId(4)) == std::vector<int>{0, 2});
  CHECK(generators_on(windows, HalfedgeId(3)) == std::vector<int>{1});
  CHECK(generators_on(windows, HalfedgeId(5)).empty());
  std::vector<int> of_face;
  windows.for_each(FaceId(1), [&](const Window& w) { of_face.push_back(w.generator.value()); });
  CHECK(of_face == std::vector<int>{0, 1, 2});
  int count = 0;
  windows.for_each(FaceId(3), [&](const Window&) { ++count; });
  CHECK(count == 0);
}

TEST_CASE("each window has its own departure, in whichever list it was kept") {
  const Progress silent;
  std::vector<KeptWindows> lists(2);
  for (int i = 0; i < 600; ++i) {
    KeptWindows& list = lists[i % 3 == 0 ? 0 : 1];
    list.windows.push_back(on(3 * (i % 3 == 0 ? 0 : 1) + i % 2, i));
    list.departures.push_back(Departure::of_angle(0.01 * i));
  }
  const EdgeWindows windows(std::move(lists), 2, ParallelChunks(1, silent));
  for (const FaceId f : {FaceId(0), FaceId(1)}) {
    const Chunk numbers = windows.of_face(f);
    CHECK(numbers.end - numbers.begin == (f == FaceId(0) ? 200u : 400u));
    for (std::size_t i = numbers.begin; i < numbers.end; ++i) {
      CHECK(Mesh::face(windows[i].halfedge) == f);
      CHECK(windows.departure(i) == Departure::of_angle(0.01 * windows[i].generator.value()));
    }
  }
}

}  // namespace gvd::test_window_field
