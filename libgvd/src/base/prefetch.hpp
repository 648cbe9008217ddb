#pragma once

namespace gvd {

/// Loads into the cache what will be read soon. A hint: it changes no result, and the address need not be valid.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace gvd
