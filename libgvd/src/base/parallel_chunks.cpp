// Runs chunks on oneTBB's threads or on plain threads: each thread takes the next chunk that no thread has taken, until
// none is left.
//
// Invariant: chunks start in order, and no chunk after a failed one starts. All chunks before a failed one therefore
// run, and the caller sees the failure with the least index, for any number of threads. Only the calling thread calls
// the progress callback.
#include "base/parallel_chunks.hpp"

#ifdef GVD_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace gvd {
namespace {

/// The state that the threads of one run share.
class SharedRun {
 public:
  SharedRun(std::size_t count, const StepPart& step, const std::function<void(std::size_t)>& work,
            const Progress& progress)
      : count_(count), step_(step), work_(work), progress_(progress) {}

  /// Takes items in order until none is left. Any thread may call it; it throws nothing.
  void take_items() {
    for (std::size_t i = next_++; i < count_; i = next_++) {
      if (cancelled_ || i > failed_) return;
      take(i);
    }
  }

  /// Called by the calling thread once all items have been taken.
  void finish() {
    // After a failure, too: if other threads have done all the work, the callback has not been asked yet.
    if (count_ > 0 && !cancelled_) report(failure_ ? fraction_done() : 1);
    if (cancellation_) std::rethrow_exception(cancellation_);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void take(std::size_t i) {
    try {
      work_(i);
    } catch (...) {
      fail(i);
    }
    ++done_;
    if (std::this_thread::get_id() == caller_) report(fraction_done());
  }

  void fail(std::size_t i) {
    const std::lock_guard lock(mutex_);
    if (i > failed_) return;
    failed_ = i;
    failure_ = std::current_exception();
  }

  double fraction_done() const { return double(done_) / double(count_); }

  void report(double fraction) {
    try {
      report_progress(progress_, step_, fraction);
    } catch (...) {
      cancellation_ = std::current_exception();
      cancelled_ = true;
    }
  }

  const std::size_t count_;
  const StepPart& step_;
  const std::function<void(std::size_t)>& work_;
  const Progress& progress_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::exception_ptr cancellation_;  // only the calling thread uses it
  // Items start in order, and all items before a failed one run, so that the least failed index remains here.
  std::atomic<std::size_t> failed_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr failure_;  // guarded by mutex_
  std::mutex mutex_;
};

#ifdef GVD_WITH_TBB
std::size_t most_threads(int) { return tbb::this_task_arena::max_concurrency(); }

void take_in_threads(std::size_t threads, SharedRun& shared) {
  // This starts one task for each thread that may work; a task that starts late finds no item left. It uses no separate
  // arena, because with oneTBB 2021.8, once an arena was destroyed, sometimes no worker joins any more. It is isolated
  // so that the calling thread takes no other work of its program while it waits.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(
        std::size_t{0}, threads, [&](std::size_t) { shared.take_items(); }, tbb::simple_partitioner());
  });
}
#else
/// Using more plain threads than cores gains nothing, but tests ask for it.
constexpr std::size_t kMostPlainThreads = 8;

std::size_t most_threads([[maybe_unused]] int asked) {
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
  return 1;
#else
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return asked == 0 ? cores : std::max(cores, kMostPlainThreads);
#endif
}

void take_in_threads(std::size_t threads, SharedRun& shared) {
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back([&] { shared.take_items(); });
  shared.take_items();
  for (std::thread& other : others) other.join();
}
#endif

}  // namespace

std::vector<Chunk> cut_into_chunks(std::size_t count, std::size_t size) {
  std::vector<Chunk> chunks;
  for (std::size_t begin = 0; begin < count; begin += size) chunks.push_back({begin, std::min(begin + size, count)});
  return chunks;
}

void ParallelChunks::run(std::size_t count, const StepPart& step, const std::function<void(std::size_t)>& work) const {
  SharedRun shared(count, step, work, progress_);
  const std::size_t most = most_threads(threads_);
  const std::size_t threads = std::min({threads_ == 0 ? most : std::size_t(threads_), most, count});
  if (threads <= 1) {
    shared.take_items();
  } else {
    take_in_threads(threads, shared);
    // If a surrounding oneTBB loop of the caller was cancelled, oneTBB starts no task, and all items are still to do.
    shared.take_items();
  }
  shared.finish();
}

}  // namespace gvd
