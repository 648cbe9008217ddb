#pragma once

namespace gvd {

/// Tells the processor to load memory into the cache that will be read soon. This is only a hint: it changes no result,
/// and the address need not be valid.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace gvd
