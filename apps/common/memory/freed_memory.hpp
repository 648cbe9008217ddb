#pragma once

namespace gvd::app {

/// Each arena of glibc keeps up to kKeptFreedBytes that were freed at its end, and serves requests below that from
/// them. A relaxation allocates and frees the same tens of megabytes in each iteration. By default glibc gives back
/// what exceeds twice the largest block freed so far, and the system has to clear each page of it again. Thresholds of
/// MALLOC_TRIM_THRESHOLD_, MALLOC_MMAP_THRESHOLD_ and GLIBC_TUNABLES do not count then. Does nothing with other C
/// libraries.
void keep_freed_memory() noexcept;

/// Bytes. The most that glibc takes for the size from which a block is the system's (HEAP_MAX_SIZE / 2, with 64 bits).
inline constexpr int kKeptFreedBytes = 32 << 20;

}  // namespace gvd::app
