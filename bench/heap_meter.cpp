// The peak of the heap, counted by replaced forms of operator new and delete.
//
// All allocations of the program count, so a meter tells what was allocated between two moments. Each block counts with
// the bytes that malloc gave it (malloc_usable_size), which delete can ask for again: no list of blocks is needed. Only
// the forms below are replaced: in GNU's library all others call one of them. Sanitizers have their own forms, so that
// their builds leave the benchmarks out. Blocks of malloc itself, such as those of Eigen's matrices, do not count.
// Counting takes time: a measured time and a counted peak come from two runs.
#include "heap_meter.hpp"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> g_live{0};
std::atomic<std::int64_t> g_peak{0};
std::atomic<bool> g_counting{false};

/// Counts a new block; throws std::bad_alloc where there is none.
void* count(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  if (!g_counting.load(std::memory_order_relaxed)) return block;
  const auto bytes = static_cast<std::int64_t>(malloc_usable_size(block));
  const std::int64_t live = g_live.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  std::int64_t peak = g_peak.load(std::memory_order_relaxed);
  while (live > peak && !g_peak.compare_exchange_weak(peak, live, std::memory_order_relaxed)) {
  }
  return block;
}

void release(void* block) noexcept {
  if (block != nullptr && g_counting.load(std::memory_order_relaxed)) {
    g_live.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(block)), std::memory_order_relaxed);
  }
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return count(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  return count(std::aligned_alloc(unit, (std::max<std::size_t>(size, 1) + unit - 1) / unit * unit));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace gvd::bench {

HeapMeter::HeapMeter() {
  g_live.store(0);
  g_peak.store(0);
  g_counting.store(true);
}

HeapMeter::~HeapMeter() { g_counting.store(false); }

std::int64_t HeapMeter::peak() const { return g_peak.load(); }

}  // namespace gvd::bench
