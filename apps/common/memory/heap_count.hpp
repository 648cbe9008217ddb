#pragma once

#include <cstdint>
#include <optional>

// The program's heap, counted by operators new and delete that replace those of the standard library. malloc is not
// counted: libgvd and the libraries below it call it for little. Sanitizers need the operators of their own; with them
// nothing is counted, and no limit holds.
namespace gvd::app {

/// Bytes in use by all threads. Each thread may hold back up to 64 KiB.
std::int64_t heap_bytes() noexcept;

/// Requests that would leave more than this in use throw std::bad_alloc, in all threads. Nothing: no limit. Forgets
/// refused requests. To be called before the work.
void limit_heap(std::optional<std::int64_t> bytes) noexcept;

/// The limit no longer holds in this thread. A thread that was refused a request has none either: it is to end its
/// work, and destructors and messages need some memory.
void lift_heap_limit_here() noexcept;

/// A request that was refused, by the limit or by the system.
struct RefusedRequest {
  std::int64_t size = 0;    ///< bytes
  std::int64_t in_use = 0;  ///< bytes, at that time
};

/// The first request that was refused since the last call of `limit_heap`.
std::optional<RefusedRequest> refused_request() noexcept;

}  // namespace gvd::app
