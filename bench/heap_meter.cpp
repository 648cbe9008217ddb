// The peak of the heap, counted by replaced forms of operator new and delete.
//
// All allocations of the program count, so a meter tells what was allocated between two moments. Counting takes time: a
// measured time and a counted peak come from two runs.
#include "heap_meter.hpp"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <string>

#include "replaced_new.hpp"

namespace gvd::bench {
namespace {

std::atomic<std::int64_t> g_live{0};
std::atomic<std::int64_t> g_peak{0};
std::atomic<bool> g_counting{false};

void count(void* block) noexcept {
  if (!g_counting.load(std::memory_order_relaxed)) return;
  const std::int64_t bytes = heap::usable_size(block);
  const std::int64_t live = g_live.fetch_add(bytes, std::memory_order_relaxed) + bytes;
  std::int64_t peak = g_peak.load(std::memory_order_relaxed);
  while (live > peak && !g_peak.compare_exchange_weak(peak, live, std::memory_order_relaxed)) {
  }
}

void discount(void* block) noexcept {
  if (g_counting.load(std::memory_order_relaxed)) g_live.fetch_sub(heap::usable_size(block), std::memory_order_relaxed);
}

}  // namespace

HeapMeter::HeapMeter() {
  g_live.store(0);
  g_peak.store(0);
  g_counting.store(true);
}

HeapMeter::~HeapMeter() { g_counting.store(false); }

std::int64_t HeapMeter::peak() const { return g_peak.load(); }

std::int64_t peak_resident_bytes() {
  // Not ru_maxrss: a new process begins with the peak of the one that started it there.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return 1024 * kibibytes;
  }
  return 0;
}

}  // namespace gvd::bench

void* gvd::heap::allocate(std::size_t size, std::size_t alignment) {
  void* const block = allocate_block(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  bench::count(block);
  return block;
}

void* gvd::heap::try_allocate(std::size_t size) noexcept {
  void* const block = allocate_block(size, 0);
  if (block != nullptr) bench::count(block);
  return block;
}

void gvd::heap::release(void* block) noexcept {
  if (block != nullptr) bench::discount(block);
  std::free(block);
}
