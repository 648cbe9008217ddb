#include <span>
#include <vector>

#include "geodesic/windows/block_list.hpp"
#include "support/catch.hpp"

namespace gvd::test_block_list {

TEST_CASE("more windows than 32 bits can number are refused") {
  CHECK_NOTHROW(check_window_count(0, kMostWindows));
  CHECK_NOTHROW(check_window_count(kMostWindows - 1024, 1024));
  CHECK_THROWS_AS(check_window_count(kMostWindows - 1023, 1024), Error);
}

TEST_CASE("a block list keeps its items, also those of lists that are appended") {
  BlockList<int> all;
  for (int i = 0; i < 1000; ++i) all.push_back(i);
  BlockList<int> more;
  for (int i = 0; i < 300; ++i) more.push_back(-i);
  const std::size_t first = all.append(std::move(more));
  REQUIRE(first >= 1000);
  CHECK(all.size() == first + 300);
  for (int i = 0; i < 1000; ++i) REQUIRE(all[i] == i);
  for (int i = 0; i < 300; ++i) REQUIRE(all[first + static_cast<std::size_t>(i)] == -i);
}

TEST_CASE("a block queue gives its items back in order, a block at a time") {
  BlockQueue<int> queue;
  const int block = static_cast<int>(BlockQueue<int>::kBlock);
  CHECK(queue.empty());
  for (int i = 0; i < 2 * block + 10; ++i) CHECK(queue.push_back(i) == (i == block || i == 2 * block));
  CHECK(queue.block_count() == 3);
  std::vector<int> taken;
  while (!queue.empty()) {
    const std::size_t before = taken.size();
    queue.take_block([&](std::span<const int> items) { taken.insert(taken.end(), items.begin(), items.end()); });
    CHECK(taken.size() - before == static_cast<std::size_t>(queue.empty() ? 10 : block));
  }
  REQUIRE(taken.size() == static_cast<std::size_t>(2 * block + 10));
  for (std::size_t i = 0; i < taken.size(); ++i) REQUIRE(taken[i] == static_cast<int>(i));
}

TEST_CASE("items that are added while a block is taken come after it") {
  BlockQueue<int> queue;
  for (int i = 0; i < 5; ++i) queue.push_back(i);
  std::vector<int> taken;
  const auto take = [&](std::span<const int> items) {
    for (const int i : items) {
      taken.push_back(i);
      if (i < 2) queue.push_back(100 + i);
    }
  };
  queue.take_block(take);
  CHECK(taken == std::vector<int>{0, 1, 2, 3, 4});
  queue.take_block(take);
  CHECK(taken == std::vector<int>{0, 1, 2, 3, 4, 100, 101});
  CHECK(queue.empty());
}

}  // namespace gvd::test_block_list
