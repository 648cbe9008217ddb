#include "common/memory/freed_memory.hpp"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gvd::app {

void keep_freed_memory() noexcept {
#ifdef __GLIBC__
  // To set one of the two ends glibc's own choice of the other. The first one is refused where pointers have 32 bits.
  if (mallopt(M_MMAP_THRESHOLD, kKeptFreedBytes) == 1) mallopt(M_TRIM_THRESHOLD, kKeptFreedBytes);
#endif
}

}  // namespace gvd::app
