#pragma once

namespace gvd {

/// Asks the cache for what will be read soon. A hint: it changes no result, and any address will do.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace gvd
