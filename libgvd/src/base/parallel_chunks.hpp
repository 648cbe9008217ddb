#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

#include "gvd/progress.hpp"

namespace gvd {

/// Items begin .. end - 1 of a list.
struct Chunk {
  std::size_t begin, end;
};

/// Cuts a list of `count` items into chunks of `size` >= 1 items; the last one may be shorter.
std::vector<Chunk> cut_into_chunks(std::size_t count, std::size_t size);

/// Size of a chunk for lists whose items cost no more than a few look-ups each.
inline constexpr std::size_t kScanChunk = 1 << 13;

/// Cuts a list into chunks that end as soon as their work reaches `enough`. `work(i)` is the work of item i.
template <class Work>
std::vector<Chunk> cut_by_work(std::size_t count, std::size_t enough, Work work) {
  std::vector<Chunk> chunks;
  std::size_t begin = 0, sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += work(i);
    if (sum < enough && i + 1 < count) continue;
    chunks.push_back({begin, i + 1});
    begin = i + 1;
    sum = 0;
  }
  return chunks;
}

/// Runs work on several threads, with bit-identical results for any number of threads.
///
/// This works because a list is cut into chunks by its contents alone, never by the number of threads; because a chunk
/// reads only data that nothing writes meanwhile, and has its own results and scratch memory; and because the results
/// are joined in the order of the chunks. It varies which thread takes which chunk, and when, but no result depends on
/// that. Sums over several chunks must therefore be formed after the run, in the order of the chunks.
///
/// Progress: only the calling thread calls the callback, after each chunk that it ran itself and at the end. If the
/// callback cancels, no further chunk starts, and the run waits for the chunks that have started.
/// Errors: if several chunks throw, the exception of the first of them in the list is thrown, not of the first in time.
/// No further chunk after a failed one starts. Cancelling takes precedence over errors.
class ParallelChunks {
 public:
  /// `threads` is at least 1, or 0 for all cores. With oneTBB, at most as many threads run as oneTBB provides: one per
  /// core or, inside an arena of the caller, the size of that arena. Without oneTBB, the limit is eight or one per
  /// core, whichever is larger. `progress` must outlive this object.
  ParallelChunks(int threads, const Progress& progress) : threads_(threads), progress_(progress) {}

  const Progress& progress() const { return progress_; }

  /// Runs work(i) for i = 0 .. count - 1.
  void run(std::size_t count, const StepPart& step, const std::function<void(std::size_t)>& work) const;

  /// Returns the results of compute(chunk) in the order of the chunks. The result's type must be default-constructible.
  template <class Compute>
  auto map(const std::vector<Chunk>& chunks, const StepPart& step, const Compute& compute) const {
    std::vector<std::invoke_result_t<const Compute&, const Chunk&>> results(chunks.size());
    run(chunks.size(), step, [&](std::size_t i) { results[i] = compute(chunks[i]); });
    return results;
  }

  /// Like `map`, for results that are vectors: joins them into one vector, in the order of the chunks.
  template <class Compute>
  auto collect(const std::vector<Chunk>& chunks, const StepPart& step, const Compute& compute) const {
    auto results = map(chunks, step, compute);
    std::size_t size = 0;
    for (const auto& result : results) size += result.size();
    typename decltype(results)::value_type joined;
    joined.reserve(size);
    for (auto& result : results) {
      joined.insert(joined.end(), std::make_move_iterator(result.begin()), std::make_move_iterator(result.end()));
    }
    return joined;
  }

 private:
  int threads_;
  const Progress& progress_;
};

}  // namespace gvd
