#include "for_each_index.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

#ifdef GVD_HAVE_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace gvd {
namespace {

#ifdef GVD_HAVE_TBB
template <class Step>
void run(std::size_t count, int threads, const Step& step) {
  const int cores = tbb::info::default_concurrency();  // asking for more makes oneTBB complain on stderr
  tbb::task_arena arena(threads == 0 ? cores : std::min(threads, cores));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) step(i);
        },
        tbb::simple_partitioner());
  });
}
#else
template <class Step>
void run(std::size_t count, int, const Step& step) {
  for (std::size_t i = 0; i < count; ++i) step(i);
}
#endif

}  // namespace

void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& body,
                    const std::function<void(double)>& report) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  std::vector<std::exception_ptr> failures(count);
  run(count, threads, [&](std::size_t i) {
    try {
      body(i);
    } catch (...) {
      failures[i] = std::current_exception();
    }
    const std::size_t finished = ++done;
    if (std::this_thread::get_id() == caller) report(static_cast<double>(finished) / static_cast<double>(count));
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace gvd
