#include <sys/resource.h>

#include <array>
#include <cstdint>
#include <cstdlib>  // defines __GLIBC__
#include <cstring>
#include <new>

#include "common/memory/freed_memory.hpp"
#include "common/memory/heap_count.hpp"
#include "support/catch.hpp"

namespace gvd::test_freed_memory {

using namespace app;

constexpr int kBlock = 8 << 20;
static_assert(3 * kBlock < kKeptFreedBytes);

#ifdef __GLIBC__
constexpr bool kHasGlibc = true;
#else
constexpr bool kHasGlibc = false;
#endif

std::int64_t page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

/// Three blocks at once: glibc's own thresholds adapt to two.
/// Whether the heap was counted meanwhile: sanitizers have an allocator of their own.
bool use_blocks() {
  const std::int64_t before = heap_bytes();
  std::array<void*, 3> blocks{};
  for (void*& block : blocks) {
    block = ::operator new(kBlock);
    std::memset(block, 1, kBlock);
  }
  const bool is_counted = heap_bytes() - before >= 3 * kBlock;
  for (void* const block : blocks) ::operator delete(block);
  return is_counted;
}

TEST_CASE("freed blocks are used again without faults of their pages") {
  keep_freed_memory();
  if (!use_blocks() || !kHasGlibc) return;
  const std::int64_t before = page_faults();
  for (int i = 0; i < 20; ++i) use_blocks();
  // A block that the system provides anew has 2048 pages of 4 KiB. A few faults may come from elsewhere.
  CHECK(page_faults() - before < 2048);
}

}  // namespace gvd::test_freed_memory
