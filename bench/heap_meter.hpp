#pragma once

#include <cstdint>

namespace gvd::bench {

/// Counts what this program's `new` holds. Exact and repeatable, unlike the resident size; the allocator's own
/// bookkeeping is not in it.
struct HeapUse {
  std::int64_t live = 0;  ///< bytes held now
  std::int64_t peak = 0;  ///< most bytes held at once since reset_heap_peak
};

HeapUse heap_use();
void reset_heap_peak();

/// Largest resident memory of this process so far, in bytes.
std::int64_t peak_resident_bytes();

}  // namespace gvd::bench
