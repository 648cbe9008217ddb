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

/// Size of a chunk for lists whose items take no more than a few look-ups each.
inline constexpr std::size_t kScanChunk = 1 << 13;

/// Cuts a list into chunks, each of which ends as soon as its work reaches `enough`; `work(i)` is that of item i.
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

/// Work by several threads, with the same result to the last bit for any number of them.
///
/// Reason: a list is cut into chunks by its contents alone, never by the number of threads. A chunk reads
/// only what nobody writes meanwhile, and has results and scratch memory of its own. The results are joined in the
/// order of the chunks. Chance decides which thread takes which chunk, and when, but no result depends on it. Sums over
/// several chunks must therefore be formed after the run, in the order of the chunks.
///
/// Progress: only the calling thread calls the callback, after each chunk of its own and at the end. If it cancels, no
/// further chunk is started, and those that run are waited for.
/// Errors: if chunks throw, the exception of the first one in the list is thrown, not of the first one in time. Chunks
/// after it are not started any more. Cancelling takes precedence over errors.
class ParallelChunks {
 public:
  /// `threads` >= 1, or 0 for all cores. Never more are used than oneTBB provides: one for each core or, within an
  /// arena of the caller's, as many as that allows; without oneTBB, eight or one for each core. `progress` has to
  /// outlive this.
  ParallelChunks(int threads, const Progress& progress) : threads_(threads), progress_(progress) {}

  const Progress& progress() const { return progress_; }

  /// Runs work(i) for i = 0 .. count - 1.
  void run(std::size_t count, const StepPart& step, const std::function<void(std::size_t)>& work) const;

  /// The results of compute(chunk) for every chunk, in their order. The result's type has a default.
  template <class Compute>
  auto map(const std::vector<Chunk>& chunks, const StepPart& step, const Compute& compute) const {
    std::vector<std::invoke_result_t<const Compute&, const Chunk&>> results(chunks.size());
    run(chunks.size(), step, [&](std::size_t i) { results[i] = compute(chunks[i]); });
    return results;
  }

  /// The results of `map` where they are vectors, joined to one in the order of the chunks.
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
