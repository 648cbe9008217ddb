#pragma once

#include <time.h>

namespace gvd::bench {

/// Processor time of this thread in milliseconds. Wall-clock time would also count the time slices of other processes,
/// more of them for long runs than for short ones, and so distort ratios.
inline double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace gvd::bench
