#pragma once

#include <cstdint>

namespace gvd::bench {

/// Counts what this program's `new` holds while the meter lives; outside of that it costs next to nothing, so that it
/// does not slow what is timed. Exact and repeatable, unlike the resident size; the allocator's own bookkeeping is not
/// in it.
class HeapMeter {
 public:
  HeapMeter();
  ~HeapMeter();
  HeapMeter(const HeapMeter&) = delete;
  HeapMeter& operator=(const HeapMeter&) = delete;

  /// Most bytes held at once since the meter began.
  std::int64_t peak() const;
};

/// Largest resident memory of this process so far, in bytes.
std::int64_t peak_resident_bytes();

}  // namespace gvd::bench
