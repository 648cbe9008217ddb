#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>  // defines __GLIBC__
#include <cstring>
#include <functional>
#include <new>
#include <ostream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "apps/run_command.hpp"
#include "common/process.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_process {

using namespace app;

TEST_CASE("a signal raises the flag, and installing the handlers clears it") {
  for (const int signal : {SIGINT, SIGTERM}) {
    install_signal_handlers();
    CHECK(!interrupt_requested());
    CHECK_NOTHROW(check_interrupt());
    std::raise(signal);
    CHECK(interrupt_requested());
    try {
      check_interrupt();
      FAIL("no error");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::interrupted);
    }
  }
  install_signal_handlers();
  CHECK(!interrupt_requested());
}

TEST_CASE("a closed pipe raises no flag and ends nothing") {
  install_signal_handlers();
  std::raise(SIGPIPE);
  CHECK(!interrupt_requested());
}

TEST_CASE("a second signal has its usual effect") {
  install_signal_handlers();
  std::raise(SIGTERM);
  struct sigaction now {};
  REQUIRE(sigaction(SIGTERM, nullptr, &now) == 0);
  CHECK(now.sa_handler == SIG_DFL);
  install_signal_handlers();
}

/// Standard output leads to another file while this object lives.
class Redirected {
 public:
  explicit Redirected(int target) {
    std::fflush(stdout);
    saved_ = dup(STDOUT_FILENO);
    if (saved_ < 0 || dup2(target, STDOUT_FILENO) < 0) throw std::runtime_error("no redirection for the test");
    close(target);
  }
  ~Redirected() {
    // What could not be written is left in the buffer, and would come out now.
    std::FILE* const sink = std::fopen("/dev/null", "w");
    dup2(fileno(sink), STDOUT_FILENO);
    std::fflush(stdout);
    std::fclose(sink);
    dup2(saved_, STDOUT_FILENO);
    close(saved_);
    std::clearerr(stdout);
  }

 private:
  int saved_ = -1;
};

int open_file(const std::string& path) { return dup(fileno(std::fopen(path.c_str(), "w"))); }

void write_much(std::ostream& out) {
  for (int i = 0; i < 64; ++i) out << std::string(1 << 16, 'x');
}

TEST_CASE("standard output gets what is written, whole") {
  const test::ScratchFolder scratch;
  {
    const Redirected redirected(open_file(scratch / "a"));
    write_standard_output([](std::ostream& out) {
      out << "a" << 1;
      out.put('b');
    });
    write_standard_output(write_much);
  }
  CHECK(test::read_text(scratch / "a").substr(0, 4) == "a1bx");
  CHECK(test::read_text(scratch / "a").size() == 3 + (64u << 16));
}

TEST_CASE("a failed write has its reason, and a reader that is gone an exception of its own") {
  install_signal_handlers();
  {
    const Redirected redirected(open_file("/dev/full"));
    CHECK_THROWS_WITH(write_standard_output(write_much), Catch::Matchers::Contains("No space left"));
    CHECK_THROWS_AS(write_standard_output([](std::ostream& out) { out << "a"; }), Error);
  }
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  close(ends[0]);
  const Redirected redirected(ends[1]);
  CHECK(test::refusal([] { write_standard_output(write_much); }, ErrorCode::reader_gone) ==
        "the reader of standard output is gone");
}

constexpr int kBlock = 8 << 20;
static_assert(3 * kBlock < kKeptFreedBytes);

#ifdef __GLIBC__
constexpr bool kHasGlibc = true;
#else
constexpr bool kHasGlibc = false;
#endif

std::int64_t page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

/// Three blocks at once: glibc's own thresholds adapt to two.
void use_blocks() {
  std::array<void*, 3> blocks{};
  for (void*& block : blocks) {
    block = ::operator new(kBlock);
    std::memset(block, 1, kBlock);
  }
  for (void* const block : blocks) ::operator delete(block);
}

TEST_CASE("freed blocks are used again without faults of their pages") {
  if (test::kSanitized || !kHasGlibc) return;  // sanitizers have an allocator of their own
  keep_freed_memory();
  use_blocks();
  const std::int64_t before = page_faults();
  for (int i = 0; i < 20; ++i) use_blocks();
  // A block that the system provides anew has 2048 pages of 4 KiB. A few faults may come from elsewhere.
  CHECK(page_faults() - before < 2048);
}

TEST_CASE("the peak of memory is that of the process and never falls") {
  const std::int64_t before = peak_memory_bytes();
  CHECK(before > 1000000);
  const std::vector<char> large(std::size_t{64} << 20, 1);
  const volatile char* const kept = large.data();  // or the compiler may leave the memory out
  CHECK(kept[large.size() / 2] == 1);
  CHECK(peak_memory_bytes() >= before);
  CHECK(peak_memory_bytes() > static_cast<std::int64_t>(large.size()));
}

/// Compilers leave out vectors that nobody uses, but no direct call.
void take(std::size_t bytes) { ::operator delete(::operator new(bytes)); }

TEST_CASE("a request beyond the limit is refused in any thread, and the process goes on") {
  if (test::kSanitized) return;  // they reserve more than any limit
  constexpr std::size_t kLarge = std::size_t{1} << 30;
  limit_memory(peak_memory_bytes() + (256 << 20));
  CHECK_THROWS_AS(take(kLarge), std::bad_alloc);
  bool refused = false;
  std::thread([&] {
    try {
      take(kLarge);
    } catch (const std::bad_alloc&) {
      refused = true;
    }
  }).join();
  CHECK(refused);
  CHECK_NOTHROW(take(1 << 20));
  limit_memory({});
  CHECK_NOTHROW(take(kLarge));
}

}  // namespace gvd::test_process
