#include "common/memory/heap_count.hpp"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

#if defined(__has_feature)
#define GVD_CLANG_SANITIZER (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define GVD_CLANG_SANITIZER 0
#endif
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !GVD_CLANG_SANITIZER
#define GVD_COUNTS_HEAP
#include "common/memory/replaced_new.hpp"
#endif

namespace gvd::app {
namespace {

constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();

std::atomic<std::int64_t> g_in_use{0}, g_limit{kNone};
std::atomic<std::int64_t> g_refused_size{-1}, g_refused_in_use{0};
/// Counts the calls of limit_heap. A thread without limit has the number of the call that it ignores.
std::atomic<std::int32_t> g_run{1};
constinit thread_local std::int32_t t_unlimited_run = 0;

}  // namespace

std::int64_t heap_bytes() noexcept { return g_in_use.load(std::memory_order_relaxed); }

void limit_heap(std::optional<std::int64_t> bytes) noexcept {
  g_refused_size = -1;
  ++g_run;
  g_limit = bytes.value_or(kNone);
}

void lift_heap_limit_here() noexcept { t_unlimited_run = g_run; }

std::optional<RefusedRequest> refused_request() noexcept {
  const std::int64_t size = g_refused_size;
  return size < 0 ? std::nullopt : std::optional(RefusedRequest{size, g_refused_in_use});
}

#ifdef GVD_COUNTS_HEAP
namespace {

/// A thread tells the others of this many bytes at a time: telling them of each block would cost more than the block.
constexpr std::int64_t kBatch = std::int64_t{1} << 16;
constinit thread_local std::int64_t t_untold = 0;

/// Of glibc, in front of each block.
constexpr std::int64_t kBlockHeader = 8;

void count(std::int64_t bytes) noexcept {
  t_untold += bytes;
  if (t_untold < kBatch && t_untold > -kBatch) return;
  g_in_use.fetch_add(t_untold, std::memory_order_relaxed);
  t_untold = 0;
}

std::int64_t size_of(void* block) noexcept { return heap::usable_size(block) + kBlockHeader; }

void note_refused(std::size_t size) noexcept {
  std::int64_t none = -1;
  g_refused_in_use = heap_bytes();
  g_refused_size.compare_exchange_strong(none, static_cast<std::int64_t>(size));
  lift_heap_limit_here();
}

bool passes_limit(std::size_t size) noexcept {
  const std::int64_t limit = g_limit.load(std::memory_order_relaxed);
  if (limit == kNone || t_unlimited_run == g_run.load(std::memory_order_relaxed)) return false;
  return heap_bytes() > limit || static_cast<std::uint64_t>(size) > static_cast<std::uint64_t>(limit - heap_bytes());
}

/// Null where there is no memory, or no more is allowed.
void* allocate_within_limit(std::size_t size, std::size_t alignment) noexcept {
  if (passes_limit(size)) return nullptr;
  void* const block = heap::allocate_block(size, alignment);
  if (block != nullptr) count(size_of(block));
  return block;
}

}  // namespace
#endif

}  // namespace gvd::app

#ifdef GVD_COUNTS_HEAP
void* gvd::heap::allocate(std::size_t size, std::size_t alignment) {
  void* const block = app::allocate_within_limit(size, alignment);
  if (block != nullptr) return block;
  app::note_refused(size);
  throw std::bad_alloc();
}

/// Who asks without exceptions has a way round and goes on, so nothing is noted.
void* gvd::heap::try_allocate(std::size_t size) noexcept { return app::allocate_within_limit(size, 0); }

void gvd::heap::release(void* block) noexcept {
  if (block != nullptr) app::count(-app::size_of(block));
  std::free(block);
}
#endif
