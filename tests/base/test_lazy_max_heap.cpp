#include <algorithm>
#include <vector>

#include "base/lazy_max_heap.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_lazy_max_heap {

TEST_CASE("lazy heap: without items it is empty") {
  CHECK(LazyMaxHeap<>(0, [](std::int32_t) { return 1.0; }).empty());
}

TEST_CASE("lazy heap: of equal keys the smallest id comes first") {
  const auto key = [](std::int32_t) { return 2.0; };
  LazyMaxHeap heap(4, key);
  for (const int expected : {0, 1, 2, 3}) {
    CHECK(heap.top(key).id == expected);
    heap.pop();
  }
  CHECK(heap.empty());
}

TEST_CASE("lazy heap: a key that fell is noticed when its item comes to the top") {
  std::vector<double> keys{5, 4, 3};
  const auto key = [&](std::int32_t id) { return keys[std::size_t(id)]; };
  LazyMaxHeap heap(3, key);
  keys[0] = 1;
  CHECK(heap.top(key).id == 1);
  CHECK(heap.top(key).key == 4);
  keys[1] = 0;
  CHECK(heap.top(key).id == 2);
}

TEST_CASE("lazy heap: always the largest of all true keys, while they fall at random") {
  test::Random random(9);
  constexpr int kCount = 60;
  std::vector<double> keys;
  for (int i = 0; i < kCount; ++i) keys.push_back(random.below(40));
  const auto key = [&](std::int32_t id) { return keys[std::size_t(id)]; };
  LazyMaxHeap heap(kCount, key);
  std::vector<char> popped(kCount, 0);
  for (int left = kCount; left > 0; --left) {
    for (int i = 0; i < 5; ++i) keys[std::size_t(random.below(kCount))] *= 0.75;
    std::int32_t expected = -1;
    for (std::int32_t id = 0; id < kCount; ++id) {
      if (!popped[std::size_t(id)] && (expected < 0 || key(id) > key(expected))) expected = id;
    }
    const LazyMaxHeap<>::Item top = heap.top(key);
    REQUIRE(top.id == expected);
    REQUIRE(top.key == key(expected));
    popped[std::size_t(top.id)] = 1;
    heap.pop();
  }
  CHECK(heap.empty());
}

}  // namespace gvd::test_lazy_max_heap
