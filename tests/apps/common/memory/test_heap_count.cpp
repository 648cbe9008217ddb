#include <cstdint>
#include <new>
#include <thread>

#include "common/memory/heap_count.hpp"
#include "support/catch.hpp"

namespace gvd::test_heap_count {

using namespace app;

constexpr std::int64_t kMegabyte = 1 << 20;

struct LimitOff {
  ~LimitOff() { limit_heap({}); }
};

/// Compilers leave out vectors that nobody uses, but no direct call.
void take(std::int64_t bytes) { ::operator delete(::operator new(static_cast<std::size_t>(bytes))); }

/// Sanitizers have operators of their own.
bool counts() {
  const std::int64_t before = heap_bytes();
  void* const block = ::operator new(kMegabyte);
  const bool counted = heap_bytes() - before >= kMegabyte;
  ::operator delete(block);
  return counted;
}

TEST_CASE("the heap is counted, and what is freed no longer") {
  if (!counts()) return;
  const std::int64_t before = heap_bytes();
  take(8 * kMegabyte);
  CHECK(heap_bytes() < before + kMegabyte);
  struct alignas(64) Line {
    char bytes[64];
  };
  Line* const line = new Line[1 << 15];
  CHECK(reinterpret_cast<std::uintptr_t>(line) % 64 == 0);
  CHECK(heap_bytes() - before > kMegabyte);
  delete[] line;
}

TEST_CASE("a request that passes the limit is refused and noted, in any thread, and the thread may end its work") {
  if (!counts()) return;
  const LimitOff off;
  limit_heap(heap_bytes() + 4 * kMegabyte);
  CHECK(!refused_request());
  bool refused = false, cleaned = false;
  std::thread([&] {
    try {
      take(8 * kMegabyte);
    } catch (const std::bad_alloc&) {
      refused = true;
    }
    take(8 * kMegabyte);
    cleaned = true;
  }).join();
  CHECK(refused);
  CHECK(cleaned);
  REQUIRE(refused_request());
  CHECK(refused_request()->size == 8 * kMegabyte);
  CHECK_THROWS_AS(take(8 * kMegabyte), std::bad_alloc);
  limit_heap({});
  CHECK(!refused_request());
  CHECK_NOTHROW(take(8 * kMegabyte));
}

TEST_CASE("a limit that is lifted in a thread holds again from the next one on") {
  if (!counts()) return;
  const LimitOff off;
  limit_heap(kMegabyte);
  lift_heap_limit_here();
  CHECK_NOTHROW(take(8 * kMegabyte));
  const std::int64_t limit = heap_bytes() + kMegabyte;
  limit_heap(limit);
  CHECK_THROWS_AS(take(8 * kMegabyte), std::bad_alloc);
}

}  // namespace gvd::test_heap_count
