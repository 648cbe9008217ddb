#pragma once

namespace gvd::app {

/// The program keeps up to kKeptFreedBytes that it freed, and requests below that are served from what is kept. By
/// default glibc gives large blocks back to the system at once, which has to clear each page of the next one again:
/// a relaxation allocates and frees the same tens of megabytes in each iteration. Does nothing with other C libraries.
void keep_freed_memory() noexcept;

/// Bytes. The most that glibc takes for the size from which a block is the system's (HEAP_MAX_SIZE / 2, with 64 bits).
inline constexpr int kKeptFreedBytes = 32 << 20;

}  // namespace gvd::app
