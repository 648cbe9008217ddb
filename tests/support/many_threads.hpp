#pragma once

#ifdef GVD_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <array>

namespace gvd::test {

/// Numbers of threads that have to make no difference.
inline constexpr std::array<int, 4> kThreads{1, 2, 3, 8};

/// Does `work` where as many threads are to be had as are asked for, up to 8, however few cores there are.
template <class Work>
void with_many_threads(const Work& work) {
#ifdef GVD_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena(8).execute(work);
#else
  work();
#endif
}

}  // namespace gvd::test
