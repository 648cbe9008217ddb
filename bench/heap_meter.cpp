#include "heap_meter.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>

namespace gvd::bench {
namespace {

std::atomic<std::int64_t> g_live{0};
std::atomic<std::int64_t> g_peak{0};
std::atomic<bool> g_counting{false};

void* counted(void* block) {
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

/// aligned_alloc requires a size that is a multiple of the alignment.
std::size_t padded(std::size_t size, std::size_t alignment) { return (size + alignment - 1) / alignment * alignment; }

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

// The forms that return nothing instead of throwing call the others in the standard library, but not in that of
// sanitizers.
void* operator new(std::size_t size) { return gvd::bench::counted(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* block = std::malloc(size == 0 ? 1 : size);
  return block == nullptr ? nullptr : gvd::bench::counted(block);
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept { return operator new(size, nothrow); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto bytes = static_cast<std::size_t>(alignment);
  return gvd::bench::counted(std::aligned_alloc(bytes, gvd::bench::padded(size == 0 ? 1 : size, bytes)));
}
void operator delete(void* block) noexcept { gvd::bench::release(block); }
void operator delete(void* block, std::size_t) noexcept { gvd::bench::release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { gvd::bench::release(block); }
void operator delete[](void* block) noexcept { gvd::bench::release(block); }
void operator delete[](void* block, std::size_t) noexcept { gvd::bench::release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { gvd::bench::release(block); }
void operator delete(void* block, std::align_val_t) noexcept { gvd::bench::release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { gvd::bench::release(block); }
