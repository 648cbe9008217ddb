#ifdef GVD_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/many_threads.hpp"

namespace gvd::test_parallel_chunks {

const Progress kSilent;

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

/// The items of some chunks, one after the other.
std::vector<std::size_t> items(const std::vector<Chunk>& chunks) {
  std::vector<std::size_t> all;
  for (const Chunk& chunk : chunks) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) all.push_back(i);
  }
  return all;
}

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

/// How many of `count` items are begun if the calling thread cancels after its first one. Each item throws if `fails`.
int begun_until_cancelled(int threads, int count, bool fails) {
  std::atomic<int> begun = 0;
  std::atomic<bool> asked = false;
  const std::thread::id caller = std::this_thread::get_id();
  const Progress cancel = [&](std::string_view, double) {
    asked = true;
    return false;
  };
  const auto work = [&](std::size_t) {
    ++begun;
    // Only the calling thread asks. Without this, the others could do all work before it gets a processor.
    while (!asked && std::this_thread::get_id() != caller) wait_a_little();
    wait_a_little();
    if (fails) throw std::runtime_error("too");
  };
  try {
    ParallelChunks(threads, cancel).run(static_cast<std::size_t>(count), {"step"}, work);
    FAIL("was not cancelled");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::interrupted);
  }
  return begun;
}

TEST_CASE("chunks hold every item once, in order") {
  for (const std::size_t count : {0, 1, 2, 7, 8, 9, 100}) {
    for (const std::size_t size : {1, 3, 8, 1000}) {
      const auto chunks = cut_into_chunks(count, size);
      CHECK(items(chunks) == first(count));
      CHECK(chunks.size() == (count + size - 1) / size);
      CHECK(items(cut_by_work(count, size, [](std::size_t i) { return i % 5; })) == first(count));
    }
  }
}

TEST_CASE("chunks end where their work is enough") {
  const std::vector<std::size_t> work{1, 1, 1, 9, 1, 2, 1};
  const auto chunks = cut_by_work(work.size(), 3, [&](std::size_t i) { return work[i]; });
  std::vector<std::size_t> ends;
  for (const Chunk& chunk : chunks) ends.push_back(chunk.end);
  CHECK(ends == std::vector<std::size_t>{3, 4, 6, 7});
}

TEST_CASE("every item is worked on once, for any number of threads") {
  test::with_many_threads([] {
    for (const int threads : {0, 1, 2, 3, 8, 100}) {
      for (const std::size_t count : {0, 1, 2, 1000}) {
        std::vector<int> times(count, 0);
        ParallelChunks(threads, kSilent).run(count, {"step"}, [&](std::size_t i) { ++times[i]; });
        CHECK(times == std::vector<int>(count, 1));
      }
    }
  });
}

TEST_CASE("results are joined in the order of the chunks, whichever was ready first") {
  test::with_many_threads([] {
    for (const int threads : test::kThreads) {
      const auto joined =
          ParallelChunks(threads, kSilent).collect(cut_into_chunks(100, 7), {"step"}, [](const Chunk& chunk) {
            if (chunk.begin % 2 == 0) wait_a_little();
            return items({chunk});
          });
      CHECK(joined == first(100));
    }
  });
}

TEST_CASE("several threads take part") {
  test::with_many_threads([] {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    ParallelChunks(8, kSilent).run(200, {"step"}, [&](std::size_t) {
      wait_a_little();
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    CHECK(seen.size() > 1);
    CHECK(seen.size() <= 8);
  });
}

TEST_CASE("the first chunk's error is thrown, whichever came first in time") {
  test::with_many_threads([] {
    for (const int threads : test::kThreads) {
      for (int repetition = 0; repetition < 20; ++repetition) {
        try {
          ParallelChunks(threads, kSilent).run(64, {"step"}, [](std::size_t i) {
            if (i == 5) wait_a_little();
            if (i >= 5) throw Error(ErrorCode::no_valid_result, "chunk", static_cast<std::int64_t>(i));
          });
          FAIL("no error");
        } catch (const Error& error) {
          CHECK(error.element() == 5);
        }
      }
    }
  });
}

TEST_CASE("nothing is begun after an error that comes later in the order") {
  std::vector<std::size_t> begun;
  CHECK_THROWS_AS(ParallelChunks(1, kSilent)
                      .run(10, {"step"},
                           [&](std::size_t i) {
                             begun.push_back(i);
                             if (i == 3) throw std::runtime_error("three");
                           }),
                  std::runtime_error);
  CHECK(begun == first(4));
}

TEST_CASE("progress comes from the calling thread alone, rises, and ends at the step's end") {
  test::with_many_threads([] {
    for (const int threads : test::kThreads) {
      std::vector<double> fractions;
      bool foreign = false;
      const std::thread::id caller = std::this_thread::get_id();
      const Progress progress = [&](std::string_view step, double fraction) {
        foreign = foreign || std::this_thread::get_id() != caller || step != "step";
        fractions.push_back(fraction);
        return true;
      };
      ParallelChunks(threads, progress).run(100, {"step", 0.25, 0.75}, [](std::size_t) {});
      CHECK_FALSE(foreign);
      CHECK(std::is_sorted(fractions.begin(), fractions.end()));
      CHECK(fractions.front() > 0.25);
      CHECK(fractions.back() == 0.75);
    }
  });
}

TEST_CASE("cancelling ends the work, and goes before errors") {
  test::with_many_threads([] {
    for (const bool fails : {false, true}) {
      for (const int threads : test::kThreads) {
        INFO(threads << " threads, " << (fails ? "with" : "without") << " errors");
        CHECK(begun_until_cancelled(threads, 10000, fails) < 10000);
      }
    }
  });
}

#ifdef GVD_WITH_TBB
TEST_CASE("within a loop of the caller's that was cancelled, all items are run nevertheless") {
  tbb::task_group_context context;
  std::atomic<int> done = 0;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        context.cancel_group_execution();
        const Progress none;
        ParallelChunks(2, none).run(100, {"step"}, [&](std::size_t) { ++done; });
      },
      tbb::simple_partitioner(), context);
  CHECK(done == 100);
}
#endif

}  // namespace gvd::test_parallel_chunks
