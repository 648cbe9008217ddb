#pragma once

#include <time.h>

namespace gvd::bench {

/// Processor time of this thread in milliseconds. What is measured runs on one thread; wall time would also count the
/// time that other processes take, and a run longer than a time slice more of it than a short one: ratios would be
/// wrong.
inline double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace gvd::bench
