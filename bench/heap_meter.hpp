#pragma once

#include <cstdint>

namespace gvd::bench {

/// The memory of a diagram, as tables 1 and 2 of the paper ask for it: counts the bytes that this program's `new` holds
/// while the meter exists. Without a meter the counting costs almost nothing, so that it does not slow down timed runs.
/// Exact and repeatable, unlike the resident size; without the allocator's own bookkeeping.
class HeapMeter {
 public:
  HeapMeter();
  ~HeapMeter();
  HeapMeter(const HeapMeter&) = delete;
  HeapMeter& operator=(const HeapMeter&) = delete;

  /// Most bytes held at once since the meter began.
  std::int64_t peak() const;
};

}  // namespace gvd::bench
