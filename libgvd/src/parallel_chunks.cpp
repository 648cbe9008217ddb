#include "parallel_chunks.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace gvd {
namespace {

/// What the threads of one run share.
class SharedRun {
 public:
  SharedRun(std::size_t count, const StepPart& step, const std::function<void(std::size_t)>& work,
            const Progress& progress)
      : count_(count), step_(step), work_(work), progress_(progress) {}

  /// Item i, by any thread. Throws nothing.
  void take(std::size_t i) {
    if (cancelled_ || i > failed_) return;
    try {
      work_(i);
    } catch (...) {
      fail(i);
    }
    const std::size_t done = ++done_;
    if (std::this_thread::get_id() == caller_) report(static_cast<double>(done) / static_cast<double>(count_));
  }

  /// By the calling thread, when all items were taken.
  void finish() {
    if (count_ > 0 && !cancelled_ && !failure_) report(1);
    if (cancellation_) std::rethrow_exception(cancellation_);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void fail(std::size_t i) {
    const std::lock_guard lock(mutex_);
    if (i > failed_) return;
    failed_ = i;
    failure_ = std::current_exception();
  }

  void report(double part) {
    try {
      report_progress(progress_, step_.name, step_.from + (step_.to - step_.from) * part);
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
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::exception_ptr cancellation_;  // the calling thread's
  // Items before the first failure are all run, so the failure that stays is that of the least index.
  std::atomic<std::size_t> failed_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr failure_;  // under the mutex
  std::mutex mutex_;
};

}  // namespace

std::vector<Chunk> cut_into_chunks(std::size_t count, std::size_t size) {
  std::vector<Chunk> chunks;
  for (std::size_t begin = 0; begin < count; begin += size) chunks.push_back({begin, std::min(begin + size, count)});
  return chunks;
}

void ParallelChunks::run(std::size_t count, const StepPart& step, const std::function<void(std::size_t)>& work) const {
  SharedRun shared(count, step, work, progress_);
  // oneTBB complains on standard error when it is asked for more than it may have.
  const std::size_t cores = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const std::size_t threads = std::min({threads_ == 0 ? cores : static_cast<std::size_t>(threads_), cores, count});
  if (threads <= 1) {
    for (std::size_t i = 0; i < count; ++i) shared.take(i);
  } else {
    // An arena of its own, so that a waiting thread takes no work of the caller's program in between.
    tbb::task_arena(static_cast<int>(threads)).execute([&] {
      tbb::parallel_for(
          std::size_t{0}, count, [&](std::size_t i) { shared.take(i); }, tbb::simple_partitioner());
    });
  }
  shared.finish();
}

}  // namespace gvd
